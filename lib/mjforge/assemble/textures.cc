// Textures of an object: picture files, generated textures, and the limit on pixels.

#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/names.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Default width of a generated texture, in pixels. MuJoCo has no default.
constexpr double kPixels = 64;

void FillInPixels(model::Texture& texture) {
  const double pixels = NumberOf(texture, "width", 0, kPixels);
  for (const std::string_view name : {"width", "height"})
    AddUnlessPresent({.name = name, .numbers = {pixels}}, texture.attributes);
}

}  // namespace

bool Assets::ReadPicture(FieldReader& reader, const spec::Field& field,
                         const std::filesystem::path& folder, model::Texture& texture) {
  const std::optional<std::string> name = reader.Text(field);
  if (!name) return false;
  const std::filesystem::path file = (folder / *name).lexically_normal();
  const Assembler::CachedTexture& content = assembler_.ReadTexture(file);
  const auto fail = [&](Code code, const std::string& why_not, std::string hint = {}) {
    const std::string message = fmt::format("{}: {}", reader.Owner(), why_not);
    findings_.Add(code, field.value.mark, message, std::move(hint)).files = {file.string()};
    return false;
  };
  if (!content.exists)
    return fail(Code::kModelFileNotFound, fmt::format("no file {}", Quoted(*name)),
                "file names are relative to the folder of the file that uses them");
  if (!content.pixels && content.why_not.empty())
    return fail(Code::kModelBadTexture, fmt::format("{} is not a PNG file", Quoted(*name)));
  if (!content.pixels)
    return fail(Code::kYamlCannotRead,
                fmt::format("cannot read {}: {}", Quoted(*name), content.why_not));
  texture.files.push_back({.file = file, .output_file = OutputName(file)});
  return true;
}

std::optional<int> Assets::AddTexture(sample::Evaluator& values, const spec::Material& material,
                                      const std::string& name) {
  const sample::StreamId path = sample::Child(MaterialPath(values, material), "texture");
  FieldReader reader(values, findings_, "texture of material", material.name, path);
  model::Texture texture;
  texture.name = name;
  texture.mark = material.texture.front().mark;
  texture.attributes.reserve(material.texture.size() + 2);  // room for width and height
  bool good = true;
  bool generated = false;
  for (const spec::Field& field : material.texture) {
    if (field.info->id == Key::kFile) {
      good &= ReadPicture(reader, field, material.folder, texture);
      continue;
    }
    generated |= field.info->id == Key::kBuiltin;
    good &= reader.ReadAttribute(field, texture.attributes.emplace_back());
  }
  if (!good) return std::nullopt;
  if (generated) FillInPixels(texture);
  return ShareTexture(material.name, std::move(texture));
}

void Assets::CheckPixels() {
  double pixels = 0.0;
  for (model::Texture& texture : object_.textures) {
    if (texture.files.empty())
      pixels += NumberOf(texture, "width", 0, 0) * NumberOf(texture, "height", 0, 0);
    for (const model::TextureFile& picture : texture.files) {
      const auto content = assembler_.ReadTexture(picture.file).pixels;
      pixels += static_cast<double>(content.value_or(0));
    }
    if (!(pixels > static_cast<double>(bytes::kMaxPixels))) continue;
    findings_.Add(Code::kModelBadTexture, texture.mark,
                  fmt::format("with texture '{}' the object's pictures have more than {} pixels",
                              texture.name, bytes::kMaxPixels),
                  "MuJoCo takes six bytes of memory a pixel, however small the file is");
    return;
  }
}

int Assets::ShareTexture(const std::string& own_name, model::Texture texture) {
  const auto known = FindIndex(textures_, own_name, [&](std::size_t i) {
    const model::Texture& other = object_.textures[i];
    return other.files == texture.files && other.attributes == texture.attributes;
  });
  if (known) return *known;
  const int index = static_cast<int>(object_.textures.size());
  object_.textures.push_back(std::move(texture));
  textures_.emplace(own_name, index);
  return index;
}

}  // namespace mjforge::assemble
