// Potential energy of a body that is tilted on the ground.
#include "mjforge/placing/tilting.h"

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace mjforge::placing {

using Eigen::Vector3d;

namespace {

constexpr double kRounding = 1e-10;  // m

// Directions at an angle from a given direction.
class Tilts {
 public:
  explicit Tilts(const Vector3d& from)
      : from_(from), u_(from.unitOrthogonal()), v_(from.cross(u_)) {}

  // `around`: longitude about the given direction, rad.
  Vector3d At(double angle, double around) const {
    const Vector3d way = std::cos(around) * u_ + std::sin(around) * v_;
    return std::cos(angle) * from_ + std::sin(angle) * way;
  }

 private:
  Vector3d from_;
  Vector3d u_;
  Vector3d v_;
};

template <typename Shapes>
double HeightOf(const Shapes& shapes, const Vector3d& center, const Vector3d& down) {
  double lowest = -std::numeric_limits<double>::infinity();
  for (const distance::PlacedShape& placed : shapes)
    lowest = std::max(lowest, down.dot(distance::FarthestPoint(placed, down)));
  return lowest - down.dot(center);
}

using ShapeReferences = std::vector<std::reference_wrapper<const distance::PlacedShape>>;

// Returns the shapes that can touch the ground after a tilt of at most `angle`. A tilt moves a
// point up or down by at most the angle times its distance from the centre of mass.
ShapeReferences LowShapes(const PlacedShapes& shapes, const Vector3d& center, const Vector3d& down,
                          double angle) {
  std::vector<double> depths;
  std::vector<double> moves;
  double least = -std::numeric_limits<double>::infinity();
  for (const distance::PlacedShape& placed : shapes) {
    const Eigen::AlignedBox3d& box = placed.box_W;
    const double reach =
        (box.min() - center).cwiseAbs().cwiseMax((box.max() - center).cwiseAbs()).norm();
    depths.push_back(down.dot(distance::FarthestPoint(placed, down) - center));
    moves.push_back(angle * reach + kRounding);
    least = std::max(least, depths.back() - moves.back());
  }
  ShapeReferences low;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (depths[i] + moves[i] >= least) low.emplace_back(shapes[i]);
  }
  return low;
}

}  // namespace

double CenterHeight(const PlacedShapes& shapes, const Vector3d& center, const Vector3d& down) {
  return HeightOf(shapes, center, down);
}

Vector3d LowestNear(const PlacedShapes& shapes, const Vector3d& center, const Vector3d& down,
                    double most) {
  constexpr double kFirstStep = 0.002;  // rad
  constexpr double kLastStep = 1e-8;
  constexpr int kDirections = 16;
  constexpr int kMostSteps = 100;
  const ShapeReferences low = LowShapes(shapes, center, down, most + kFirstStep);
  Vector3d best = down;
  double height = HeightOf(low, center, best);
  double step = kFirstStep;
  const double least_cosine = std::cos(most);
  for (int count = 0; step > kLastStep && count < kMostSteps; ++count) {
    if (down.dot(best) < least_cosine) break;
    const Tilts tilts(best);
    bool is_lower = false;
    for (int i = 0; i < kDirections; ++i) {
      const Vector3d tilted = tilts.At(step, 2 * std::numbers::pi * i / kDirections);
      const double tried = HeightOf(low, center, tilted);
      if (tried >= height - kRounding) continue;
      best = tilted;
      height = tried;
      is_lower = true;
    }
    if (!is_lower) step /= 2;
  }
  return best;
}

bool SinksWhenTilted(const PlacedShapes& shapes, const Vector3d& center, const Vector3d& down,
                     double angle) {
  constexpr std::size_t kDirections = 180;
  constexpr double kStep = 2 * std::numbers::pi / kDirections;
  constexpr int kBits = 24;  // accuracy of a direction
  const Tilts tilts(down);
  const ShapeReferences low = LowShapes(shapes, center, down, angle);
  const auto height_at = [&](double around) {
    return HeightOf(low, center, tilts.At(angle, around));
  };
  const double least = HeightOf(low, center, down) - kRounding;
  std::array<double, kDirections> heights;
  for (std::size_t i = 0; i < kDirections; ++i)
    heights[i] = height_at(static_cast<double>(i) * kStep);
  // A body that touches the ground at two points sinks in the two directions across the line
  // through both, which can lie between the sampled directions.
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (heights[i] < least) return true;
    const double neighbours =
        std::min(heights[(i + 1) % kDirections], heights[(i + kDirections - 1) % kDirections]);
    if (heights[i] > neighbours) continue;
    const double around = static_cast<double>(i) * kStep;
    const auto [at, lowest] =
        boost::math::tools::brent_find_minima(height_at, around - kStep, around + kStep, kBits);
    if (lowest < least) return true;
  }
  return false;
}

}  // namespace mjforge::placing
