// Orientation of boxes by the grain of their material, and mapping of textures from above.

#include "mjforge/assemble/grain.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace mjforge::assemble {
namespace {

using Unit = solid::TextureMapping::Unit;

// A box is a post, not a board, if the ratio of the shorter to the longer side of its cross section
// (perpendicular to the grain) is above this value.
constexpr double kPost = 0.5;

}  // namespace

PartTexture TextureOf(const model::Object& object, int material) {
  PartTexture texture;
  if (material < 0) return texture;
  const model::Material& its = object.materials[static_cast<std::size_t>(material)];
  if (its.texture < 0) return texture;
  const model::Texture& image = object.textures[static_cast<std::size_t>(its.texture)];
  // Skips cube textures, whose coordinates MuJoCo computes itself.
  if (TextOf(image, "type") != "2d") return texture;
  texture.is_turned = model::FindAttribute(image.attributes, "builtin") != nullptr;
  texture.mapping.unit = TextOf(its, "texuniform") == "true" ? Unit::kMetre : Unit::kWhole;
  if (const auto* repeat = model::FindAttribute(its.attributes, "texrepeat")) {
    const std::size_t last = repeat->numbers.size() - 1;
    texture.mapping.repeat = {repeat->numbers[0], repeat->numbers[last]};
  }
  // On primitive geoms, MuJoCo repeats textures with `texuniform` half as often as `texrepeat`
  // says. The division makes meshes look the same.
  if (texture.mapping.unit == Unit::kMetre) texture.mapping.repeat /= 2;
  return texture;
}

bool ReadGrain(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               PartTexture& texture) {
  const spec::Field* field = entry.Find(spec::Key::kGrain);
  if (field == nullptr) return true;
  const std::optional<std::string> word = reader.Word(*field);
  if (!word) return false;
  if (*word == "none") {
    texture.is_turned = false;
    return true;
  }
  texture.grain = static_cast<int>(std::string_view("xyz").find(*word));
  const bool has_holes = entry.Find(spec::Key::kHoles) != nullptr;
  if (*word != "z" || (type == "box" && !has_holes) || field->is_default) return true;
  return reader.Report(
      diag::Code::kModelBadValue, *field,
      fmt::format("is z; that of a {}{} is along x or y", type, has_holes ? " with holes" : ""),
      "its texture is laid on from above");
}

Eigen::Quaterniond TurnToGrain(const PartTexture& texture, Eigen::Vector3d& half) {
  if (texture.mapping.unit == Unit::kNone || !(texture.grain || texture.is_turned))
    return Eigen::Quaterniond::Identity();
  // If two edges are equally long, prefers y to x, and x and y to z.
  const auto longer = [&](int a, int b) { return half[a] > half[b] ? a : b; };
  const int grain = texture.grain.value_or(longer(2, longer(0, 1)));
  const int first = grain == 0 ? 1 : 0, second = grain == 2 ? 1 : 2;  // the other axes
  const int thin = half[first] < half[second] ? first : second;
  const int wide = first + second - thin;
  const bool is_post = half[thin] > kPost * half[wide] || half[grain] < half[thin];
  const int along_y = is_post ? thin : grain, along_z = is_post ? grain : thin;
  half = Eigen::Vector3d(half[wide], half[along_y], half[along_z]);
  const Eigen::Vector3d y = Eigen::Vector3d::Unit(along_y), z = Eigen::Vector3d::Unit(along_z);
  return model::FromXyAxes(y.cross(z), y);
}

solid::TextureMapping MappingFromAbove(const PartTexture& texture, const Eigen::Vector2d& size) {
  solid::TextureMapping mapping = texture.mapping;
  mapping.is_turned =
      texture.grain ? *texture.grain == 0 : texture.is_turned && size.x() > size.y();
  return mapping;
}

}  // namespace mjforge::assemble
