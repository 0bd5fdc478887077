// materials: and defaults:.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/reading.h"

namespace mjforge::spec {
namespace {

using diag::Code;

std::vector<Field> ReadTexture(const YamlNode& node, Reading& reading) {
  if (!IsMap(node, "a texture's keys", reading)) return {};
  CheckKeys(TextureElement(), node, reading);
  std::vector<Field> fields = ReadFields(TextureElement(), node, reading);
  if (!FindField(fields, Key::kBuiltin) && !FindField(fields, Key::kFile)) {
    reading.findings.Add(Code::kSpecMissingKey, node.mark, "a texture needs 'builtin' or 'file'");
  }
  return fields;
}

void ReadMaterial(const YamlNode::Pair& pair, const std::filesystem::path& folder,
                  Reading& reading) {
  CheckName("material", pair.key, pair.mark, reading.findings);
  if (!IsMap(pair.value, "a material's keys", reading)) return;
  CheckKeys(MaterialElement(), pair.value, reading);
  Material material{
      .name = pair.key, .mark = pair.mark, .fields = {}, .texture = {}, .folder = folder};
  material.fields = ReadFields(MaterialElement(), pair.value, reading);
  if (const YamlNode* texture = pair.value.Find("texture")) {
    material.texture = ReadTexture(*texture, reading);
  }
  reading.spec.materials.push_back(std::move(material));
}

// Keys that a default cannot give: what an entry is, and where.
constexpr Key kWithoutDefault[] = {Key::kName,   Key::kIf,        Key::kFor,    Key::kSpec,
                                   Key::kParams, Key::kMaterials, Key::kFrame,  Key::kParts,
                                   Key::kFromTo, Key::kUp,        Key::kPolygon};

void MergeDefaults(const ElementInfo& element, const YamlNode& node, std::vector<Field>& into,
                   Reading& reading) {
  if (!IsMap(node, fmt::format("a {}'s keys", element.name), reading)) return;
  CheckKeys(element, node, reading);
  for (const auto& pair : node.pairs) {
    const FieldInfo* info = element.Find(pair.key);
    if (info != nullptr &&
        std::ranges::find(kWithoutDefault, info->id) != std::end(kWithoutDefault)) {
      reading.findings.Add(Code::kSpecConflict, pair.mark,
                           fmt::format("'{}' cannot be a default", pair.key));
      return;
    }
  }
  for (Field& field : ReadFields(element, node, reading)) {
    const auto same = [&field](const Field& other) { return other.info == field.info; };
    if (std::ranges::none_of(into, same)) into.push_back(std::move(field));
  }
}

}  // namespace

void ReadMaterials(const YamlNode& materials, const std::filesystem::path& folder, bool imported,
                   Reading& reading) {
  if (!IsMap(materials, "materials", reading)) return;
  for (const auto& pair : materials.pairs) {
    const bool known = std::ranges::find(reading.spec.materials, pair.key, &Material::name) !=
                       reading.spec.materials.end();
    // What a spec says itself, or imports first, wins.
    if (!(imported && known)) ReadMaterial(pair, folder, reading);
  }
}

void ReadDefaults(const YamlNode& defaults, Reading& reading) {
  if (!IsMap(defaults, "defaults", reading)) return;
  CheckKeys(DefaultsElement(), defaults, reading);
  Defaults& into = reading.spec.defaults;
  for (const auto& pair : defaults.pairs) {
    const FieldInfo* info = DefaultsElement().Find(pair.key);
    if (info == nullptr) continue;
    if (info->id == Key::kPart) MergeDefaults(PartElement(), pair.value, into.part, reading);
    if (info->id == Key::kSite) MergeDefaults(SiteElement(), pair.value, into.site, reading);
    if (info->id == Key::kJoint) MergeDefaults(JointElement(), pair.value, into.joint, reading);
  }
}

}  // namespace mjforge::spec
