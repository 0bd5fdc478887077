// Readers of `materials:` and `defaults:`.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

std::vector<Field> ReadTexture(const YamlNode& node, Context& context) {
  if (!IsMap(node, "a texture's keys", context)) return {};
  std::vector<Field> fields = ReadElementFields(kTextureElement, node, context);
  if (!FindField(fields, Key::kBuiltin) && !FindField(fields, Key::kFile)) {
    context.findings.Add(Code::kSpecMissingKey, node.mark, "a texture needs 'builtin' or 'file'");
  }
  return fields;
}

void ReadMaterial(const YamlNode::Pair& pair, const std::filesystem::path& folder,
                  Context& context) {
  CheckName("material", pair.key, pair.mark, context.findings);
  if (!IsMap(pair.value, "a material's keys", context)) return;
  Material material{
      .name = pair.key, .mark = pair.mark, .fields = {}, .texture = {}, .folder = folder};
  material.fields = ReadElementFields(kMaterialElement, pair.value, context);
  if (const YamlNode* texture = pair.value.Find("texture")) {
    material.texture = ReadTexture(*texture, context);
  }
  context.spec.materials.push_back(std::move(material));
}

// Keys that cannot have defaults, because their values are different for each entry: name,
// condition, repetition, content, end points, outline, coupling.
constexpr Key kWithoutDefault[] = {
    Key::kName,  Key::kIf,     Key::kFor, Key::kSpec,    Key::kParams, Key::kMaterials, Key::kFrame,
    Key::kParts, Key::kFromTo, Key::kUp,  Key::kPolygon, Key::kScrew,  Key::kCouple};

void MergeDefaults(const ElementInfo& element, const YamlNode& node, std::vector<Field>& into,
                   Context& context) {
  if (!IsMap(node, fmt::format("a {}'s keys", element.name), context)) return;
  CheckKeys(element, node, context);
  for (const auto& pair : node.pairs) {
    const FieldInfo* info = element.Find(pair.key);
    if (info == nullptr) continue;
    if (std::ranges::find(kWithoutDefault, info->id) != std::end(kWithoutDefault)) {
      context.findings.Add(Code::kSpecConflict, pair.mark,
                           fmt::format("'{}' cannot be a default", pair.key));
      return;
    }
  }
  for (Field& field : ReadFields(element, node, context)) {
    const auto same = [&field](const Field& other) { return other.info == field.info; };
    if (std::ranges::none_of(into, same)) into.push_back(std::move(field));
  }
}

}  // namespace

void ReadMaterials(const YamlNode& materials, const std::filesystem::path& folder, bool imported,
                   Context& context) {
  if (!IsMap(materials, "materials", context)) return;
  for (const auto& pair : materials.pairs) {
    const bool known = std::ranges::find(context.spec.materials, pair.key, &Material::name) !=
                       context.spec.materials.end();
    // Skips an imported material if the spec or an earlier import has a material of this name.
    if (!(imported && known)) ReadMaterial(pair, folder, context);
  }
}

void ReadDefaults(const YamlNode& defaults, Context& context) {
  if (!IsMap(defaults, "defaults", context)) return;
  CheckKeys(kDefaultsElement, defaults, context);
  Defaults& into = context.spec.defaults;
  for (const auto& pair : defaults.pairs) {
    const FieldInfo* info = kDefaultsElement.Find(pair.key);
    if (info == nullptr) continue;
    if (info->id == Key::kPart) MergeDefaults(kPartElement, pair.value, into.part, context);
    if (info->id == Key::kSite) MergeDefaults(kSiteElement, pair.value, into.site, context);
    if (info->id == Key::kJoint) MergeDefaults(kJointElement, pair.value, into.joint, context);
  }
}

}  // namespace mjforge::spec
