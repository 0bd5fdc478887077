#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

constexpr std::string_view kFolder = "assets/";

// What the content of a mesh's file says.
constexpr std::string_view kMeshData[] = {"vertex", "normal", "texcoord", "face"};

using Spelling = ElementWriter::Spelling;

template <typename Vector>
void WriteVectors(std::string_view name, const std::vector<Vector>& vectors, ElementWriter& writer,
                  Spelling spelling = Spelling::kNumber) {
  if (vectors.empty()) return;
  writer.Numbers(name, {vectors.front().data(), vectors.size() * vectors.front().size()}, spelling);
}

void WriteInline(const model::MeshAsset& asset, ElementWriter& writer) {
  const model::TriangleMesh& mesh = asset.mesh;
  if (mesh.in_micrometres) writer.Raw(" scale=\"1e-06 1e-06 1e-06\"");
  WriteVectors("vertex", mesh.vertices, writer,
               mesh.in_micrometres ? Spelling::kMicrometres : Spelling::kNumber);
  // MuJoCo makes normals of the triangles that share a vertex, which differ hardly. Where a texture
  // begins and ends they share none; below square micrometres it takes their area for none.
  const bool are_computed = mesh.in_micrometres && mesh.texcoords.empty();
  if (are_computed)
    writer.Raw(" smoothnormal=\"true\"");
  else
    WriteVectors("normal", mesh.normals, writer);
  WriteVectors("texcoord", mesh.texcoords, writer);
  if (asset.is_hull) return;
  writer.Integers("face", {mesh.triangles.front().data(), 3 * mesh.triangles.size()});
}

class AssetWriter {
 public:
  AssetWriter(const model::Object& object, bool as_files, ElementWriter& writer,
              MjcfDocument& document)
      : object_(object), as_files_(as_files), writer_(writer), document_(document) {}

  void Texture(std::size_t number) {
    const model::Texture& texture = object_.textures[number];
    writer_.Open("texture", texture.mark);
    writer_.Text("name", texture.name);
    if (as_files_ && texture.files.empty()) {
      Generated(number);
    } else {
      for (const model::Attribute& attribute : texture.attributes) writer_.Attribute(attribute);
    }
    for (const model::TextureFile& picture : texture.files) {
      File(picture.attribute, picture.file, picture.output_file);
    }
    writer_.Close();
  }

  void Material(const model::Material& material) {
    writer_.Open("material", material.mark);
    writer_.Text("name", material.name);
    if (material.texture >= 0) {
      writer_.Text("texture", object_.textures[static_cast<std::size_t>(material.texture)].name);
    }
    for (const model::Attribute& attribute : material.attributes) writer_.Attribute(attribute);
    writer_.Close();
  }

  void Mesh(std::size_t number) {
    const model::MeshAsset& mesh = *object_.meshes[number];
    writer_.Open("mesh", mesh.mark);
    writer_.Text("name", mesh.name);
    // An attached file's inline vertices are among its attributes.
    const bool says_vertices = std::ranges::find(mesh.attributes, "vertex",
                                                 &model::Attribute::name) != mesh.attributes.end();
    const bool is_made = as_files_ && mesh.file.empty();
    if (!mesh.file.empty()) {
      File("file", mesh.file, mesh.output_file);
    } else if (is_made) {
      Made({.kind = MadeFile::Kind::kMesh, .number = number}, mesh.name, ".obj");
    } else if (!says_vertices) {
      WriteInline(mesh, writer_);
    }
    if (!mesh.file.empty() || says_vertices) writer_.Point("scale", mesh.scale);
    for (const model::Attribute& attribute : mesh.attributes) {
      if (!is_made || std::ranges::count(kMeshData, attribute.name) == 0)
        writer_.Attribute(attribute);
    }
    writer_.Close();
  }

 private:
  void File(std::string_view attribute, const std::filesystem::path& file,
            const std::string& output_file) {
    std::string name(kFolder);
    name += output_file;
    writer_.Text(attribute, name);
    document_.assets.push_back({.name = std::move(name), .file = file});
  }

  void Made(MadeFile file, std::string_view of, std::string_view ending) {
    std::string name = std::string(kFolder) + StemOf(of) + '_';
    const std::size_t hash = name.size();
    name.append(kHashDigits, '0').append(ending);
    writer_.Text("file", name);
    file.hash = document_.text.size() - 1 - name.size() + hash;  // 1: the quote
    document_.made_files.push_back(file);
  }

  // Several materials may have equal pictures, so they are named after the pattern.
  void Generated(std::size_t number) {
    std::string_view type = "cube";
    std::string_view pattern;
    for (const model::Attribute& attribute : object_.textures[number].attributes) {
      if (attribute.name == "type") type = attribute.text;
      if (attribute.name == "builtin") pattern = attribute.text;
    }
    writer_.Text("type", type);
    Made({.kind = MadeFile::Kind::kTexture, .number = number}, pattern, ".png");
    // MuJoCo makes the six sides of a cube one below the other.
    if (type != "2d") writer_.Raw(" gridsize=\"6 1\" gridlayout=\"RLUDFB\"");
  }

  // What it is of, without the object's own name, which may differ between variants.
  std::string StemOf(std::string_view of) const {
    if (of.starts_with(object_.name + '_')) of.remove_prefix(object_.name.size() + 1);
    constexpr std::size_t kLongest = 60;  // archives take names of 100 bytes
    // MuJoCo 2.2 folds the case of file names.
    std::string stem = diag::LowerCase(of.substr(0, kLongest));
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyz0123456789_";
    std::ranges::replace_if(
        stem, [&](char c) { return kPlain.find(c) == kPlain.npos; }, '_');
    return stem;
  }

  const model::Object& object_;
  bool as_files_;
  ElementWriter& writer_;
  MjcfDocument& document_;
};

}  // namespace

void WriteAssets(const model::Object& object, bool as_files, ElementWriter& writer,
                 MjcfDocument& document) {
  AssetWriter assets(object, as_files, writer, document);
  for (std::size_t i = 0; i < object.textures.size(); ++i) assets.Texture(i);
  for (const model::Material& material : object.materials) assets.Material(material);
  for (std::size_t i = 0; i < object.meshes.size(); ++i) assets.Mesh(i);
}

std::string TextureElement(const model::Texture& texture) {
  MjcfDocument document;
  ElementWriter writer(document);
  writer.Open("texture");
  writer.Text("name", "texture");  // MuJoCo 2.2 wants one
  for (const model::Attribute& attribute : texture.attributes) {
    if (attribute.name != "mark" || attribute.text != "random") writer.Attribute(attribute);
  }
  writer.Close();
  return document.text;
}

}  // namespace mjforge::mjcf
