#include "mjforge/solid/look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mjforge::solid {
namespace {

constexpr int kFewest = 16;  // segments of a turn
constexpr int kMost = 48;    // of what is seen of it

}  // namespace

double ChordError(double half_size, double share) { return std::min(0.25e-3, share * half_size); }

int SegmentsOf(double radius, double chord_error, double angle) {
  const double share = angle / kWholeTurn;
  int count = kFewest;
  while (radius * (1 - std::cos(std::numbers::pi / count)) > chord_error && count * share < kMost)
    count *= 2;
  return std::min(count, static_cast<int>(std::ceil(kMost / share)));
}

void AddQuad(int a, int b, int c, int d, Surface& surface) {
  surface.triangles.push_back({a, b, c});
  surface.triangles.push_back({a, c, d});
}

void LayFromAbove(const Texture& texture, Surface& surface) {
  if (texture.unit == Texture::Unit::kNone) return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : surface.vertices) box.extend(p);
  Eigen::Vector2d center = box.center().head<2>();
  Eigen::Vector2d scale = texture.repeat.cwiseQuotient(box.sizes().head<2>());
  if (texture.unit == Texture::Unit::kMetre) {
    center.setZero();
    scale = texture.repeat;
  }
  scale.y() = -scale.y();  // a picture's rows are counted from its top
  for (const Eigen::Vector3d& p : surface.vertices)
    surface.texcoords.emplace_back((p.head<2>() - center).cwiseProduct(scale).array() + 0.5);
}

void RoundForText(Surface& surface) {
  double size = 0;
  for (const Eigen::Vector3d& p : surface.vertices) size = std::max(size, p.cwiseAbs().maxCoeff());
  if (!(size > 0)) return;
  surface.in_micrometres = size >= 2e-3 && size <= 10;
  const auto round = [](auto& vectors, double per_unit) {
    // Dividing gives the double that is nearest to the decimal; adding 0 makes 0 of -0.
    for (auto& v : vectors) v = (v.array() * per_unit).round() / per_unit + 0.0;
  };
  round(surface.vertices,
        surface.in_micrometres ? 1e6 : std::pow(10, 6 - std::floor(std::log10(size))));
  round(surface.normals, 1e4);
  round(surface.texcoords, 1e5);
}

}  // namespace mjforge::solid
