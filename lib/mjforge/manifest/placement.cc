// Writing of placement.json, and its JSON Schema.

#include "mjforge/manifest/placement.h"

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::manifest {

extern const std::string_view kPlacementSchemaJson;  // content of placement.schema.json

namespace {

using diag::Json;

// Writes a single number as a number, and several numbers as a list.
void PutNumbers(Json& json, const model::AttributeNumbers& numbers) {
  numbers.size() == 1 ? json.Value(numbers[0]) : json.Value(numbers);
}

void PutElement(Json& json, const model::Element& element) {
  json.Object(element.tag, [&] {
    for (const model::Attribute& attribute : element.attributes) {
      json.Key(attribute.name);
      attribute.numbers.empty() ? json.Value(attribute.text) : PutNumbers(json, attribute.numbers);
    }
    for (const model::Element& child : element.children) PutElement(json, child);
  });
}

void PutObject(Json& json, const PlacedFile& object) {
  json.Member("file", object.file);
  json.Member("pos", object.pose.p);
  json.Member("quat", model::Wxyz(object.pose.q));
  if (!object.at.empty()) json.Member("at", object.at);
  json.Member("free", object.is_free);
  if (object.joints.empty()) return;
  json.Object("joints", [&] {
    for (const auto& [name, position] : object.joints) {
      json.Key(name);
      PutNumbers(json, position);
    }
  });
}

}  // namespace

void AppendFileNumber(std::string& out, double value) {
  expr::AppendNumber(out, mjcf::FlushNoise(value));
}

std::string PlacementText(const Placement& placement) {
  const mjcf::Provenance& provenance = placement.provenance;
  Json json(AppendFileNumber);
  json.StartObject();
  json.Member("mjforge", provenance.version);
  json.Member("name", provenance.name);
  json.Member("spec", provenance.spec);
  json.Member("spec_sha256", provenance.spec_sha256);
  json.Member("seed", provenance.seed);
  if (provenance.place_seed) json.Member("place_seed", *provenance.place_seed);
  json.Member("index", provenance.index);
  json.Member("target", provenance.target);
  for (const model::Element& option : placement.options) PutElement(json, option);
  json.Key("objects");
  std::string text = json.Take();
  const char* before = "{\n";
  for (const PlacedFile& object : placement.objects) {
    Json line(AppendFileNumber, text + before);
    line.Object(object.name, [&] { PutObject(line, object); });
    text = line.Take();
    before = ",\n";
  }
  return text + "\n}}\n";
}

std::string PlacementSchema() { return std::string(kPlacementSchemaJson); }

}  // namespace mjforge::manifest
