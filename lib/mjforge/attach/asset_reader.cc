// AssetReader: adds materials, textures and meshes of the compiled model to an attachment, once
// each.
#include "mjforge/attach/asset_reader.h"

#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

#include "mjforge/attach/attributes.h"
#include "mjforge/engine/engine.h"

namespace mjforge::attach {
namespace {

constexpr std::string_view kTextureAttributes[] = {
    "type", "builtin", "mark",   "gridlayout", "hflip",  "vflip",   "rgb1",
    "rgb2", "markrgb", "random", "width",      "height", "gridsize"};

void ReadTexture(const XmlElement& element, model::Texture& out) {
  CopyAttributes(element, kTextureAttributes, out.attributes);
  // Ignores the files of a texture with a generated pattern (`builtin`), as MuJoCo does.
  const std::string* builtin = element.Find("builtin");
  if (builtin != nullptr && *builtin != "none") return;
  for (const std::string_view name : xml::kFileAttributes) {
    const std::string* text = element.Find(name);
    if (text == nullptr || text->empty()) continue;
    out.files.push_back({name, *text, {}});
    if (name == "file") return;  // with `file`, MuJoCo ignores the files of single sides
  }
}

}  // namespace

int AssetReader::Texture(int id) {
  if (id < 0) return -1;
  const auto [place, is_new] =
      texture_numbers_.try_emplace(id, static_cast<int>(out_.textures.size()));
  if (!is_new) return place->second;
  scope_.Add(mjOBJ_TEXTURE, id);
  model::Texture& texture = out_.textures.emplace_back();
  scope_.Label(mjOBJ_TEXTURE, id, texture);
  if (const XmlElement* element = file_.ElementOf(mjOBJ_TEXTURE, id)) {
    ReadTexture(*element, texture);
  }
  return place->second;
}

int AssetReader::Material(int id) {
  if (id < 0) return -1;
  const auto [place, is_new] =
      material_numbers_.try_emplace(id, static_cast<int>(out_.materials.size()));
  if (!is_new) return place->second;
  scope_.Add(mjOBJ_MATERIAL, id);
  const mjModel& m = file_.model();
  model::Material material;
  scope_.Label(mjOBJ_MATERIAL, id, material);
  material.texture = Texture(engine::TextureOf(m, id));
  Attributes(spec::kMaterialElement, material.attributes).Read(m, mjOBJ_MATERIAL, id);
  out_.materials.push_back(std::move(material));
  return place->second;
}

std::string AssetReader::MaterialName(int id) {
  const int number = Material(id);
  return number < 0 ? "" : out_.materials[static_cast<std::size_t>(number)].name;
}

int AssetReader::Mesh(int id) {
  const auto [place, is_new] = mesh_numbers_.try_emplace(id, static_cast<int>(out_.meshes.size()));
  if (!is_new) return place->second;
  scope_.Add(mjOBJ_MESH, id);
  auto mesh = std::make_unique<model::MeshAsset>(meshes_.Read(id));
  mesh->name = scope_.Name(mjOBJ_MESH, id);
  out_.meshes.push_back(std::move(mesh));
  return place->second;
}

}  // namespace mjforge::attach
