#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

constexpr std::string_view kFolder = "assets/";

void WriteFile(std::string_view attribute, const std::filesystem::path& file,
               const std::string& output_file, ElementWriter& writer, MjcfDocument& document) {
  std::string name(kFolder);
  name += output_file;
  writer.Text(attribute, name);
  document.assets.emplace_back(std::move(name), file);
}

void WriteTexture(const model::Texture& texture, ElementWriter& writer, MjcfDocument& document) {
  writer.Open("texture", texture.mark);
  writer.Text("name", texture.name);
  for (const model::Attribute& attribute : texture.attributes) writer.Attribute(attribute);
  for (const model::TextureFile& picture : texture.files) {
    WriteFile(picture.attribute, picture.file, picture.output_file, writer, document);
  }
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

using Spelling = ElementWriter::Spelling;

template <typename Vector>
void WriteVectors(std::string_view begin, const std::vector<Vector>& vectors, tape::Tape* tape,
                  ElementWriter& writer, Spelling spelling = Spelling::kNumber) {
  if (vectors.empty()) return;
  writer.Raw(begin);
  for (const Vector& vector : vectors) {
    for (const double& number : vector) {
      writer.Append(
          tape == nullptr ? Traced<double>(number) : Traced<double>(number, *tape, number),
          spelling);
    }
  }
  writer.Raw("\"");
}

void WriteInline(const model::MeshAsset& asset, ElementWriter& writer) {
  const model::TriangleMesh& mesh = asset.mesh;
  if (mesh.in_micrometres) writer.Raw(" scale=\"1e-06 1e-06 1e-06\"");
  WriteVectors(" vertex=\"", mesh.vertices, mesh.tape, writer,
               mesh.in_micrometres ? Spelling::kMicrometres : Spelling::kNumber);
  // MuJoCo makes normals of the triangles that share a vertex, which differ hardly. Where a texture
  // begins and ends they share none; below square micrometres it takes their area for none.
  const bool are_computed = mesh.in_micrometres && mesh.texcoords.empty();
  if (are_computed)
    writer.Raw(" smoothnormal=\"true\"");
  else
    WriteVectors(" normal=\"", mesh.normals, mesh.tape, writer);
  WriteVectors(" texcoord=\"", mesh.texcoords, mesh.tape, writer);
  if (asset.is_hull) return;
  writer.Raw(" face=\"");
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int corner : triangle) writer.Append(corner);
  }
  writer.Raw("\"");
}

void WriteMesh(const model::MeshAsset& mesh, ElementWriter& writer, MjcfDocument& document) {
  writer.Open("mesh", mesh.mark);
  writer.Text("name", mesh.name);
  // An attached file's inline vertices are among its attributes.
  const bool says_vertices = std::ranges::find(mesh.attributes, "vertex",
                                               &model::Attribute::name) != mesh.attributes.end();
  if (!mesh.file.empty()) {
    WriteFile("file", mesh.file, mesh.output_file, writer, document);
    writer.Point("scale", mesh.scale);
  } else if (says_vertices) {
    writer.Point("scale", mesh.scale);
  } else {
    WriteInline(mesh, writer);
  }
  for (const model::Attribute& attribute : mesh.attributes) writer.Attribute(attribute);
  writer.Close();
}

}  // namespace

void WriteAssets(const model::Object& object, ElementWriter& writer, MjcfDocument& document) {
  for (const model::Texture& texture : object.textures) WriteTexture(texture, writer, document);
  for (const model::Material& material : object.materials) WriteMaterial(object, material, writer);
  for (const auto& mesh : object.meshes) WriteMesh(*mesh, writer, document);
}

}  // namespace mjforge::mjcf
