// Writing of placement.json, and its JSON Schema.

#include "mjforge/manifest/placement.h"

#include <cmath>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::manifest {
namespace {

using diag::Json;

constexpr const char* kSchema = R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "title": "mjforge placement",
  "description": "placement.json: the objects of a scene, of which each has a file of its own.",
  "type": "object",
  "additionalProperties": false,
  "required": ["mjforge", "name", "spec", "spec_sha256", "seed", "index", "target", "objects"],
  "properties": {
    "mjforge": {
      "description": "The version of mjforge that wrote it.",
      "type": "string"
    },
    "name": {
      "description": "The scene's name.",
      "type": "string"
    },
    "spec": {
      "description": "The spec: its name in the catalogue, or its file's name.",
      "type": "string"
    },
    "spec_sha256": {
      "description": "SHA-256 of the text of all files that the spec was read from.",
      "type": "string", "pattern": "^[0-9a-f]{64}$"
    },
    "seed": {
      "description": "The seed of all draws.",
      "type": "integer", "minimum": 0
    },
    "place_seed": {
      "description": "The seed of the places alone; left out if they follow from `seed`.",
      "type": "integer", "minimum": 0
    },
    "index": {
      "description": "The variant's number in the family.",
      "type": "integer", "minimum": 0
    },
    "target": {
      "description": "The host that the files are written for.",
      "type": "string"
    },
    "option": {
      "description": "MJCF's <option> that the scene asks for, such as those that a pile rests with; left out if there is none.",
      "type": "object"
    },
    "objects": {
      "description": "The objects by name, in the order of the spec.",
      "type": "object",
      "additionalProperties": {
        "type": "object",
        "additionalProperties": false,
        "required": ["file", "pos", "quat", "free"],
        "properties": {
          "file": {
            "description": "Its file, relative to this one.",
            "type": "string"
          },
          "pos": {
            "description": "Position of its root body in the scene at the start, m.",
            "type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3
          },
          "quat": {
            "description": "Orientation of its root body in the scene at the start: w x y z.",
            "type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4
          },
          "at": {
            "description": "The region or site that it stands at, as in the spec; left out if it was not placed.",
            "type": "string"
          },
          "free": {
            "description": "true: it can be moved (a free joint); false: it is fixed to the world.",
            "type": "boolean"
          },
          "joints": {
            "description": "Positions at the start of its other joints, by their names in the file, as in qpos: m or rad, of a ball joint w x y z; left out if it has none.",
            "type": "object",
            "additionalProperties": {"type": ["number", "array"], "items": {"type": "number"}}
          }
        }
      }
    }
  }
}
)";

// Appends a number as MJCF files have it: values below 1e-15 are rounding errors of rotations.
void AppendFlushed(std::string& out, double value) {
  expr::AppendNumber(out, std::abs(value) < 1e-15 ? 0 : value);
}

// A single number is no list.
void PutNumbers(Json& json, const sample::Numbers& numbers) {
  numbers.size() == 1 ? json.Value(numbers[0]) : json.Value(numbers);
}

void PutElement(Json& json, const model::Element& element) {
  json.StartObject();
  for (const model::Attribute& attribute : element.attributes) {
    json.Key(attribute.name);
    attribute.numbers.empty() ? json.Value(attribute.text) : PutNumbers(json, attribute.numbers);
  }
  for (const model::Element& child : element.children) {
    json.Key(child.tag);
    PutElement(json, child);
  }
  json.EndObject();
}

void PutObject(Json& json, const PlacedFile& object) {
  json.StartObject();
  json.Member("file", object.file);
  json.Member("pos", object.pose.p);
  json.Member("quat", model::Wxyz(object.pose.q));
  if (!object.at.empty()) json.Member("at", object.at);
  json.Member("free", object.is_free);
  if (!object.joints.empty()) {
    json.Key("joints");
    json.StartObject();
    for (const auto& [name, position] : object.joints) {
      json.Key(name);
      PutNumbers(json, position);
    }
    json.EndObject();
  }
  json.EndObject();
}

}  // namespace

std::string PlacementText(const Placement& placement) {
  const mjcf::Provenance& provenance = placement.provenance;
  Json json(AppendFlushed);
  json.StartObject();
  json.Member("mjforge", provenance.version);
  json.Member("name", provenance.name);
  json.Member("spec", provenance.spec);
  json.Member("spec_sha256", provenance.spec_sha256);
  json.Member("seed", provenance.seed);
  if (provenance.place_seed) json.Member("place_seed", *provenance.place_seed);
  json.Member("index", provenance.index);
  json.Member("target", provenance.target);
  for (const model::Element& option : placement.options) {
    json.Key("option");
    PutElement(json, option);
  }
  json.Key("objects");
  std::string text = json.Take();
  const char* before = "{\n";
  for (const PlacedFile& object : placement.objects) {
    Json line(AppendFlushed, text + before);
    line.Key(object.name);
    PutObject(line, object);
    text = line.Take();
    before = ",\n";
  }
  return text + "\n}}\n";
}

std::string PlacementSchema() { return kSchema; }

}  // namespace mjforge::manifest
