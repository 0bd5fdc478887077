// Writers of a variant's values, facts and joints, and of a part's properties, as JSON for the page
// of `mjforge customize`.

#include "mjforge/customize/variant_json.h"

namespace mjforge::customize {
namespace {

void WriteValues(diag::Json& json, const ShownVariant& shown) {
  json.Object("values", [&] {
    if (shown.variant) json.Members(shown.variant->record.params);
  });
}

// Writes `facts`: mass (kg), size (m) and counts of the object; null if there is no object.
void WriteFacts(diag::Json& json, const ShownVariant& shown) {
  if (!shown.variant || shown.variant->object == nullptr) return json.Member("facts", nullptr);
  const manifest::Record& record = shown.variant->record;
  const model::Object& object = *shown.variant->object;
  json.Object("facts", [&] {
    json.Member("mass", object.mass_properties.mass);
    json.Member("size", Eigen::Vector3d(2 * object.bounds.half_size()));
    json.Member("bodies", object.bodies.size());
    json.Member("geoms", record.ngeom);
    json.Member("attempt", record.attempt);
  });
}

void WriteJoints(diag::Json& json, const ShownVariant& shown) {
  std::vector<picture::Joint> movable = shown.joints;
  std::erase_if(movable, [](const picture::Joint& joint) { return !joint.IsMovable(); });
  json.Each("joints", movable, [&](const picture::Joint& joint) {
    json.Member("name", joint.name);
    json.Member("type", joint.type == picture::Joint::Type::kHinge ? "hinge" : "slide");
    json.Member("limited", joint.limited);
    json.Member("range", joint.range);
    json.Member("value", joint.value);
  });
}

}  // namespace

void WritePart(diag::Json& json, const ShownVariant& shown, std::string_view geom) {
  if (geom.ends_with(model::kVisualSuffix)) geom.remove_suffix(model::kVisualSuffix.size());
  const model::Object& object = *shown.variant->object;
  const model::Part* found = nullptr;
  double mass = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) {
      if (part.name == geom) found = &part;
    }
  }
  if (found == nullptr) return;
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts)
      mass += part.NameInSpec() == found->NameInSpec() ? part.mass : 0;
  }
  json.Member("part", found->NameInSpec());
  if (found->material >= 0)
    json.Member("material", object.materials[static_cast<std::size_t>(found->material)].name);
  json.Member("mass", mass);
  if (!found->mark) return;
  json.Member("file", diag::SafeText(shown.sources.Name(found->mark.file)));
  json.Member("line", found->mark.line);
}

void WriteVariant(diag::Json& json, const ShownVariant& shown) {
  WriteValues(json, shown);
  WriteFacts(json, shown);
  WriteJoints(json, shown);
}

}  // namespace mjforge::customize
