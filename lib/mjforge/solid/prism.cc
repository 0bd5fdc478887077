#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "mjforge/solid/convex.h"
#include "mjforge/solid/look.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/plan.h"
#include "mjforge/solid/stack.h"

namespace mjforge::solid {
namespace {

/// Of a rounded corner as it is seen, a whole turn.
int CornerSegments(const Prism& prism) {
  Eigen::AlignedBox2d box;
  for (const Point& p : prism.polygon) box.extend(p);
  const double half_size = std::max(box.sizes().maxCoeff(), prism.height) / 2;
  return SegmentsOf(prism.round, ChordError(half_size), kWholeTurn);
}

Mass MassOf(const Plan& plan, double height, double bevel) {
  // Along z all integrals are polynomials of at most degree 6 in each layer.
  using Rule = boost::math::quadrature::gauss<double, 7>;
  Moments moments;
  const auto add_slice = [&](double z, double inset, double thickness) {
    const AreaMoments slice = MomentsOf(plan.BorderAt(inset));
    moments.volume += thickness * slice.area;
    const Eigen::Vector3d first(slice.first.x(), slice.first.y(), z * slice.area);
    moments.first += thickness * first;
    moments.second.topLeftCorner<2, 2>() += thickness * slice.second;
    moments.second.col(2) += thickness * z * first;
    moments.second.row(2).head<2>() += thickness * z * slice.first;
  };
  const auto add_layer = [&](double below, double above, double inset, double grows) {
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double side : {-1, 1}) {
        const double x = side * Rule::abscissa()[i];
        if (x == 0 && side > 0) continue;
        const double z = (below + above) / 2 + x * (above - below) / 2;
        add_slice(z, inset + grows * (z - below), Rule::weights()[i] * (above - below) / 2);
      }
    }
  };
  const double top = height / 2;
  add_layer(bevel - top, top - bevel, 0, 0);
  if (bevel > 0) {
    add_layer(-top, bevel - top, bevel, -1);
    add_layer(top - bevel, top, 0, 1);
  }
  return MassOf(moments, Eigen::Vector3d::Zero());
}

/// Pieces of all convex polygons of an area, between -z and z.
void AddPieces(const Area& area, double z, std::vector<Piece>& pieces) {
  for (const std::vector<int>& polygon : PartitionOf(area).convex) {
    std::vector<Point> corners;
    corners.reserve(polygon.size());
    for (const int corner : polygon)
      corners.push_back(area.corners[static_cast<std::size_t>(corner)]);
    RemoveStraightCorners(corners);
    pieces.push_back(StackOf({{corners, -z}, {corners, z}}));
  }
}

std::vector<Piece> PiecesOf(const Plan& plan, const Prism& prism) {
  const Levels levels = plan.LevelsAt(prism.bevel, prism.facets, true);
  const double top = prism.height / 2;
  const double edge = top - prism.bevel;
  std::vector<Piece> pieces;
  if (prism.bevel > 0 && levels.middle.ends.size() == 1 && IsConvex(levels.middle.corners)) {
    const std::vector<Point>& inner = levels.end.corners;
    const std::vector<Point>& outer = levels.middle.corners;
    pieces.push_back(StackOf({{inner, -top}, {outer, -edge}, {outer, edge}, {inner, top}}));
    return pieces;
  }
  AddPieces(levels.middle, edge, pieces);
  // What the bevel leaves of it goes through from end to end.
  if (prism.bevel > 0) AddPieces(levels.end, top, pieces);
  return pieces;
}

}  // namespace

std::optional<Solid> Make(const Prism& prism, Fault& fault) {
  const std::optional<Plan> plan = PlanOf(prism, fault);
  if (!plan) return std::nullopt;
  Solid solid;
  solid.look = Make(PrismLook{.levels = plan->LevelsAt(prism.bevel, CornerSegments(prism), false),
                              .height = prism.height,
                              .bevel = prism.bevel,
                              .crease = prism.crease,
                              .texture = prism.texture});
  solid.pieces = PiecesOf(*plan, prism);
  solid.mass = MassOf(*plan, prism.height, prism.bevel);
  return solid;
}

}  // namespace mjforge::solid
