// Writers of textures, materials and meshes.

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// Attributes of <mesh> that are not written if a generated file contains the same data.
constexpr std::string_view kMeshData[] = {"vertex", "normal", "texcoord", "face"};

using NumberFormat = ElementWriter::NumberFormat;

template <typename Vector>
void WriteVectors(std::string_view name, const std::vector<Vector>& vectors, ElementWriter& writer,
                  NumberFormat format = NumberFormat::kExact) {
  if (vectors.empty()) return;
  writer.WriteNumbers(name, {vectors.front().data(), vectors.size() * vectors.front().size()},
                      format);
}

void WriteInline(const model::MeshAsset& asset, ElementWriter& writer) {
  const model::TriangleMesh& mesh = asset.mesh;
  if (mesh.in_micrometres) writer.WriteRaw(" scale=\"1e-06 1e-06 1e-06\"");
  WriteVectors("vertex", mesh.vertices, writer,
               mesh.in_micrometres ? NumberFormat::kMicrometres : NumberFormat::kExact);
  // Omits normals where MuJoCo computes almost the same ones, from the triangles that share a
  // vertex. MuJoCo's normals are wrong at the seam of a texture, where triangles share no vertex,
  // and for triangles below a square micrometre, whose area MuJoCo treats as zero.
  const bool are_computed = mesh.in_micrometres && mesh.texcoords.empty();
  if (are_computed)
    writer.WriteRaw(" smoothnormal=\"true\"");
  else
    WriteVectors("normal", mesh.normals, writer);
  WriteVectors("texcoord", mesh.texcoords, writer);
  if (asset.is_hull) return;
  writer.WriteIntegers("face", {mesh.triangles.front().data(), 3 * mesh.triangles.size()});
}

class AssetWriter {
 public:
  AssetWriter(const model::Object& object, bool as_files, ElementWriter& writer,
              MjcfDocument& document)
      : object_(object), as_files_(as_files), writer_(writer), document_(document) {}

  void WriteTexture(std::size_t index) {
    const model::Texture& texture = object_.textures[index];
    writer_.OpenElement("texture", texture.mark);
    writer_.WriteText("name", texture.name);
    if (as_files_ && texture.files.empty()) {
      WriteGeneratedTexture(index);
    } else {
      for (const model::Attribute& attribute : texture.attributes)
        writer_.WriteAttribute(attribute);
    }
    for (const model::TextureFile& picture : texture.files) {
      WriteFile(picture.attribute, picture.file, picture.output_file);
    }
    writer_.CloseEmpty();
  }

  void WriteMaterial(const model::Material& material) {
    writer_.OpenElement("material", material.mark);
    writer_.WriteText("name", material.name);
    if (material.texture >= 0) {
      writer_.WriteText("texture",
                        object_.textures[static_cast<std::size_t>(material.texture)].name);
    }
    for (const model::Attribute& attribute : material.attributes) writer_.WriteAttribute(attribute);
    writer_.CloseEmpty();
  }

  void WriteMesh(std::size_t index) {
    const model::MeshAsset& mesh = *object_.meshes[index];
    writer_.OpenElement("mesh", mesh.mark);
    writer_.WriteText("name", mesh.name);
    // For a mesh of an attached file, inline vertices are among the attributes.
    const bool has_vertices = model::FindAttribute(mesh.attributes, "vertex") != nullptr;
    const bool is_generated = as_files_ && mesh.file.empty();
    if (!mesh.file.empty()) {
      WriteFile("file", mesh.file, mesh.output_file);
    } else if (is_generated) {
      WriteGeneratedFile({.kind = GeneratedFile::Kind::kMesh, .index = index}, mesh.name, ".obj");
    } else if (!has_vertices) {
      WriteInline(mesh, writer_);
    }
    if (!mesh.file.empty() || has_vertices) writer_.WritePoint("scale", mesh.scale);
    for (const model::Attribute& attribute : mesh.attributes) {
      if (!is_generated || std::ranges::count(kMeshData, attribute.name) == 0)
        writer_.WriteAttribute(attribute);
    }
    writer_.CloseEmpty();
  }

 private:
  void WriteFile(std::string_view attribute, const std::filesystem::path& file,
                 const std::string& output_file) {
    std::string name(kAssetFolder);
    name += output_file;
    writer_.WriteText(attribute, name);
    document_.assets.push_back({.name = std::move(name), .file = file});
  }

  void WriteGeneratedFile(GeneratedFile file, std::string_view label, std::string_view extension) {
    std::string name = std::string(kAssetFolder) + StemOf(label) + '_';
    const std::size_t hash = name.size();
    name.append(bytes::kHashDigits, '0').append(extension);
    writer_.WriteText("file", name);
    file.hash_position = writer_.size() - 1 - name.size() + hash;  // 1 for the closing quote
    document_.generated_files.push_back(file);
  }

  // Writes a reference to a generated file. Names the file after the texture's pattern, not after
  // the texture, because several textures may share one image.
  void WriteGeneratedTexture(std::size_t index) {
    const model::Texture& texture = object_.textures[index];
    const std::string_view type = TextOf(texture, "type", "cube");
    writer_.WriteText("type", type);
    WriteGeneratedFile({.kind = GeneratedFile::Kind::kTexture, .index = index},
                       TextOf(texture, "builtin"), ".png");
    // MuJoCo generates the six sides of a cube one below the other.
    if (type != "2d") writer_.WriteRaw(" gridsize=\"6 1\" gridlayout=\"RLUDFB\"");
  }

  // Returns the beginning of an asset's file name: `label` in lower case, without the prefix of the
  // object's name, which may differ between variants.
  std::string StemOf(std::string_view label) const {
    if (label.starts_with(object_.name + '_')) label.remove_prefix(object_.name.size() + 1);
    constexpr std::size_t kLongest = 60;  // names in archives have at most 100 bytes
    // MuJoCo 2.2 ignores the case of file names.
    std::string stem = diag::LowerCase(label.substr(0, kLongest));
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
  for (std::size_t i = 0; i < object.textures.size(); ++i) assets.WriteTexture(i);
  for (const model::Material& material : object.materials) assets.WriteMaterial(material);
  for (std::size_t i = 0; i < object.meshes.size(); ++i) assets.WriteMesh(i);
}

std::string TextureElement(const model::Texture& texture) {
  MjcfDocument document;
  ElementWriter writer(document);
  writer.OpenElement("texture");
  writer.WriteText("name", "texture");  // required by MuJoCo 2.2
  for (const model::Attribute& attribute : texture.attributes) {
    if (attribute.name != "mark" || attribute.text != "random") writer.WriteAttribute(attribute);
  }
  writer.CloseEmpty();
  writer.Finish();
  return std::move(document.text);
}

}  // namespace mjforge::mjcf
