// Search for the largest free disc in a region by branch and bound over squares. When the centre of
// a free disc moves, its largest radius changes by no more than the distance.

#include "mjforge/placing/widest_gap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <queue>
#include <vector>

#include "mjforge/placing/placing.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;

constexpr double kPrecision = 5e-4;  // m, error of the radius
constexpr int kMostSquares = 1'000;
const std::array kCorners = {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)};

// A square of the plane of the region, and the radius of the largest free disc around its middle.
struct Square {
  Vector2d middle;
  double half;
  double radius;

  // Returns an upper bound of the radius of free discs whose middle is in the square.
  double Most() const { return radius + std::numbers::sqrt2 * half; }
  bool operator<(const Square& other) const { return Most() < other.Most(); }
};

Eigen::AlignedBox2d BoxOf(const model::Region& region) {
  if (region.type == model::RegionType::kPolygon) return solid::BoxAround(region.corners);
  return {-region.half_size, region.half_size};
}

}  // namespace

double WidestGap(const model::Region& region, const model::Pose& X_WR, double height,
                 const Obstacles& obstacles, const Support& support) {
  const auto square_at = [&](const Vector2d& middle, double half) -> Square {
    const double inside = -model::DistanceOutside(region, middle) - region.margin;
    if (inside <= 0) return {middle, half, inside};
    model::Pose X_RC;
    X_RC.p = {middle.x(), middle.y(), kContactGap + height / 2};
    return {middle, half, obstacles.FreeRadius(X_WR * X_RC, height / 2, inside, support)};
  };
  const Eigen::AlignedBox2d box = BoxOf(region);
  std::priority_queue<Square> squares;
  squares.push(square_at(box.center(), box.sizes().maxCoeff() / 2));
  double widest = std::max(squares.top().radius, 0.0);
  for (int i = 0; i < kMostSquares && !squares.empty(); ++i) {
    const Square square = squares.top();
    if (square.Most() <= widest + kPrecision) break;
    squares.pop();
    const double half = square.half / 2;
    for (const Vector2d& way : kCorners) {
      const Square next = square_at(square.middle + half * way, half);
      widest = std::max(widest, next.radius);
      squares.push(next);
    }
  }
  return 2 * widest;
}

}  // namespace mjforge::placing
