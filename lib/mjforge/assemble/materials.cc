// Materials: lookup by name, replacement by a material of the outer spec, evaluation, and sharing.

#include "mjforge/assemble/materials.h"

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {

using diag::Code;
using spec::Key;

bool Materials::Read(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                     const MaterialState*& material) {
  const spec::Field* field = entry.Find(Key::kMaterial);
  if (field == nullptr) return true;
  const std::optional<std::string> name = reader.Text(*field);
  if (name) material = Find(scope, *name, field->value.mark);
  return name && material != nullptr;
}

const MaterialState* Materials::Find(Scope& scope, const std::string& name, diag::SourceMark mark) {
  const auto other =
      std::ranges::find(scope.substitutes, name, &std::pair<std::string, std::string>::first);
  if (other != scope.substitutes.end()) return Find(*scope.outer, other->second, mark);
  const std::vector<spec::Material>& materials = scope.values.spec().materials;
  const auto found = std::ranges::find(materials, name, &spec::Material::name);
  if (found == materials.end()) {
    findings_.Add(Code::kSpecUnknownMaterial, mark, fmt::format("no material {}", Quoted(name)),
                  diag::DidYouMean(name, materials, &spec::Material::name));
    return nullptr;
  }
  MaterialState& state = scope.materials[static_cast<std::size_t>(found - materials.begin())];
  if (!state.is_evaluated) Evaluate(scope, *found, state);
  return &state;
}

// Evaluates a material. Evaluate() is called once per material and object, so that all parts with
// the material have the same drawn values.
void Materials::Evaluate(Scope& scope, const spec::Material& material, MaterialState& state) {
  state.is_evaluated = true;
  FieldReader reader(scope.values, findings_, "material", material.name,
                     MaterialPath(scope.values, material));
  model::Material look;
  look.name = scope.prefix + material.name;
  look.mark = material.mark;
  look.attributes.reserve(material.fields.size());
  for (const spec::Field& field : material.fields) {
    if (field.info->id == Key::kDensity) {
      state.density = reader.Number(field);
      state.density_field = &field;
    } else if (field.info->id == Key::kAttribute || field.info->id == Key::kRgba) {
      const bool is_contact = field.info->applies == spec::Applies::kCollision;
      std::vector<model::Attribute>& attributes = is_contact ? state.contact : look.attributes;
      reader.ReadAttribute(field, attributes.emplace_back());
    }
  }
  if (!material.texture.empty()) {
    look.texture = assets_.AddTexture(scope.values, material, look.name).value_or(-1);
  }
  if (look.attributes.empty() && look.texture < 0) return;
  state.index = Share(material.name, std::move(look));
}

int Materials::Share(const std::string& own_name, model::Material material) {
  const auto known = FindIndex(by_name_, own_name, [&](std::size_t i) {
    const model::Material& other = object_.materials[i];
    return other.texture == material.texture && other.attributes == material.attributes;
  });
  if (known) return *known;
  const int index = static_cast<int>(object_.materials.size());
  object_.materials.push_back(std::move(material));
  by_name_.emplace(own_name, index);
  return index;
}

}  // namespace mjforge::assemble
