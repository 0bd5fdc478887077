// Generation of the OBJ and PNG files of meshes and textures, whose names contain hashes of their
// contents.

#include "mjforge/files/files.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/engine/engine.h"
#include "mjforge/files/obj.h"
#include "mjforge/files/texture.h"

namespace mjforge::files {
namespace {

using mjcf::GeneratedFile;

// Maximum number of cached textures. A generated texture usually is the same in all variants.
constexpr std::size_t kMostKept = 64;

// An output file that is named by a hash of its content: its bytes, and the hash.
struct Content {
  std::shared_ptr<const std::string> bytes;
  std::string hash;
};

// Hashes the pixels instead of the PNG, whose bytes depend on the version of the compressor.
Content ContentOf(const TexturePixels& picture) {
  const bytes::Pixels pixels = {
      .width = picture.width, .height = picture.height, .colors = picture.rgb};
  const std::string_view colors(reinterpret_cast<const char*>(picture.rgb.data()),
                                picture.rgb.size());
  return {std::make_shared<const std::string>(bytes::EncodePng(pixels)),
          bytes::HashOf(fmt::format("{} {} {}", picture.width, picture.height, colors))};
}

}  // namespace

struct Maker::State {
  std::optional<engine::Engine> engine;     // created for the first texture
  std::map<std::string, Content> textures;  // key: MJCF element and attribute `mark`

  // Functions that make one file. Each returns nullopt, after adding a finding, if the file cannot
  // be made.
  std::optional<Content> MeshFile(const model::MeshAsset& mesh, diag::Findings& findings) const;
  std::optional<Content> TextureFile(const model::Texture& texture, diag::Findings& findings);
};

Maker::Maker() : state_(std::make_unique<State>()) {}
Maker::~Maker() = default;

std::optional<Content> Maker::State::MeshFile(const model::MeshAsset& mesh,
                                              diag::Findings& findings) const {
  std::string why_not;
  std::optional<std::string> obj = ObjOf(mesh, why_not);
  if (!obj) {
    findings.Add(diag::Code::kModelBadMesh, mesh.mark,
                 fmt::format("mesh '{}' has no faces, and its hull {}", mesh.name, why_not));
    return std::nullopt;
  }
  std::string hash = bytes::HashOf(*obj);
  return Content{std::make_shared<const std::string>(*std::move(obj)), std::move(hash)};
}

std::optional<Content> Maker::State::TextureFile(const model::Texture& texture,
                                                 diag::Findings& findings) {
  std::string key = mjcf::TextureElement(texture);
  for (const model::Attribute& attribute : texture.attributes) {
    if (attribute.name == "mark") key += attribute.text;
  }
  if (const auto known = textures.find(key); known != textures.end()) return known->second;
  if (!engine) engine.emplace();
  std::string why_not;
  const std::optional<TexturePixels> picture = PixelsOf(texture, *engine, why_not);
  if (!picture) {
    findings.Add(diag::Code::kMujocoError, texture.mark,
                 fmt::format("MuJoCo cannot make texture '{}': {}", texture.name, why_not));
    return std::nullopt;
  }
  if (textures.size() >= kMostKept) textures.clear();
  return textures.emplace(std::move(key), ContentOf(*picture)).first->second;
}

bool Maker::Make(const model::Object& object, mjcf::MjcfDocument& document,
                 diag::Findings& findings) {
  std::string& text = document.text;
  for (const GeneratedFile& file : std::exchange(document.generated_files, {})) {
    const std::optional<Content> content =
        file.kind == GeneratedFile::Kind::kMesh
            ? state_->MeshFile(*object.meshes[file.index], findings)
            : state_->TextureFile(object.textures[file.index], findings);
    if (!content) return false;
    text.replace(file.hash_position, content->hash.size(), content->hash);
    const std::size_t begin = text.rfind('"', file.hash_position) + 1;
    const std::string name = text.substr(begin, text.find('"', file.hash_position) - begin);
    // Adds each file once, because equal meshes can have the same file name.
    if (std::ranges::count(document.assets, name, &bytes::Asset::name) == 0)
      document.assets.push_back({.name = name, .made = content->bytes});
  }
  return true;
}

}  // namespace mjforge::files
