// Segment counts, texture projection and rounding of render meshes.

#include "mjforge/solid/render_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace mjforge::solid {
namespace {

// Returns the nearest whole number. Rounds halves away from zero, like std::round, but without a
// call of the C library, and never returns -0. Numbers from 2^52 on are whole. Adds slightly less
// than 0.5: with 0.5, the number just below 0.5 would become 1.
double RoundToWhole(double number) {
  constexpr double kBelowHalf = 0x1.fffffffffffffp-2;
  if (!(std::abs(number) < 0x1p52)) return number;
  return static_cast<double>(static_cast<std::int64_t>(number + std::copysign(kBelowHalf, number)));
}

}  // namespace

double ChordError(double half_size, double share) { return std::min(0.25e-3, share * half_size); }

int SegmentsPerTurn(double radius, double chord_error, double angle) {
  constexpr int kFewest = 16;       // fewest segments in a whole turn
  constexpr int kMostVisible = 48;  // most segments within `angle`
  const double share = angle / kWholeTurn;
  int count = kFewest;
  while (radius * (1 - std::cos(std::numbers::pi / count)) > chord_error &&
         count * share < kMostVisible)
    count *= 2;
  return std::min(count, static_cast<int>(std::ceil(kMostVisible / share)));
}

void AddQuad(int a, int b, int c, int d, TriangleMesh& mesh) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

void AddFace(const std::vector<std::array<int, 3>>& triangles, int first, bool is_reversed,
             TriangleMesh& mesh) {
  for (const auto& [a, b, c] : triangles) {
    mesh.triangles.push_back(
        {first + a, first + (is_reversed ? c : b), first + (is_reversed ? b : c)});
  }
}

void ProjectTextureFromAbove(const TextureMapping& texture, TriangleMesh& mesh) {
  if (texture.unit == TextureMapping::Unit::kNone) return;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(OnPicture(texture, p.head<2>()));
  Eigen::Vector2d center = box.center();
  Eigen::Vector2d scale = texture.repeat.cwiseQuotient(box.sizes());
  if (texture.unit == TextureMapping::Unit::kMetre) {
    center.setZero();
    scale = texture.repeat;
  }
  for (const Eigen::Vector3d& p : mesh.vertices) {
    const Point2 at = OnPicture(texture, p.head<2>()) - center;
    mesh.texcoords.emplace_back(at.cwiseProduct(scale).array() + 0.5);
  }
}

void RoundCoordinates(TriangleMesh& mesh) {
  double size = 0;
  for (const Eigen::Vector3d& p : mesh.vertices) size = std::max(size, p.cwiseAbs().maxCoeff());
  if (!(size > 0)) return;
  mesh.in_micrometres = size >= 2e-3 && size <= 10;
  const auto round = [](auto& vectors, double per_unit) {
    // Divides instead of multiplying, because the quotient is the double nearest to the decimal
    // number.
    for (auto& v : vectors) {
      for (double& number : v) number = RoundToWhole(number * per_unit) / per_unit;
    }
  };
  round(mesh.vertices, mesh.in_micrometres ? 1e6 : std::pow(10, 6 - std::floor(std::log10(size))));
  round(mesh.normals, 1e4);
  round(mesh.texcoords, 1e5);
}

}  // namespace mjforge::solid
