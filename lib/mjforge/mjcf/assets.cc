#include <filesystem>

#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

constexpr std::string_view kFolder = "assets/";

void WriteFile(const std::filesystem::path& file, const std::string& output_file,
               ElementWriter& writer, MjcfDocument& document) {
  std::string name(kFolder);
  name += output_file;
  writer.Text("file", name);
  document.assets.emplace_back(std::move(name), file);
}

void WriteTexture(const model::Texture& texture, ElementWriter& writer, MjcfDocument& document) {
  writer.Open("texture", texture.mark);
  writer.Text("name", texture.name);
  for (const model::Attribute& attribute : texture.attributes) writer.Attribute(attribute);
  if (!texture.file.empty()) WriteFile(texture.file, texture.output_file, writer, document);
  writer.Close();
}

void WriteMaterial(const model::Object& object, const model::Material& material,
                   ElementWriter& writer) {
  writer.Open("material", material.mark);
  writer.Text("name", material.name);
  if (material.texture >= 0) {
    writer.Text("texture", object.textures[static_cast<std::size_t>(material.texture)].name);
  }
  for (const model::Attribute& attribute : material.attributes) writer.Attribute(attribute);
  writer.Close();
}

/// MuJoCo makes the faces of inline vertices itself, as their convex hull.
void WriteMesh(const model::MeshAsset& mesh, ElementWriter& writer, MjcfDocument& document) {
  writer.Open("mesh", mesh.mark);
  writer.Text("name", mesh.name);
  if (mesh.file.empty()) {
    writer.Raw(" vertex=\"");
    bool first = true;
    for (const Eigen::Vector3d& vertex : mesh.mesh.vertices) {
      for (const double coordinate : vertex) {
        if (!first) document.text += ' ';
        first = false;
        expr::AppendNumber(document.text, coordinate);
      }
    }
    writer.Raw("\"");
  } else {
    WriteFile(mesh.file, mesh.output_file, writer, document);
    writer.Vector("scale", mesh.scale);
  }
  writer.Close();
}

}  // namespace

void WriteAssets(const model::Object& object, ElementWriter& writer, MjcfDocument& document) {
  for (const model::Texture& texture : object.textures) WriteTexture(texture, writer, document);
  for (const model::Material& material : object.materials) WriteMaterial(object, material, writer);
  for (const auto& mesh : object.meshes) WriteMesh(*mesh, writer, document);
}

}  // namespace mjforge::mjcf
