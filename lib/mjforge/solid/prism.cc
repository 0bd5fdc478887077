// Prisms with holes, rounded corners and bevelled edges.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "mjforge/solid/convex_partition.h"
#include "mjforge/solid/cut_prism.h"
#include "mjforge/solid/inset_polygon.h"
#include "mjforge/solid/loft.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

/// Returns the number of segments, in a whole turn, of the rounded corners of the render mesh.
int CornerSegments(const Prism& prism) {
  const Point2 sides = BoxAround(prism.polygon).sizes();
  const double half_size = std::max(sides.maxCoeff(), prism.height) / 2;
  return SegmentsPerTurn(prism.round, ChordError(half_size), kWholeTurn);
}

Mass MassOf(const BasePolygon& base, double height, double bevel) {
  // Gauss rule for one layer, with vertical walls or one bevel, in which all integrands are
  // polynomials in z of degree 6 at most.
  using Rule = boost::math::quadrature::gauss<double, 7>;
  const std::vector<std::vector<ArcDirections>> directions = base.Directions();
  const auto slice_at = [&](double inset) { return MomentsOf(base.BoundaryAt(inset, directions)); };
  Moments moments;
  const auto add_slice = [&](double z, const AreaMoments& slice, double thickness) {
    moments.volume += thickness * slice.area;
    const Eigen::Vector3d first(slice.first.x(), slice.first.y(), z * slice.area);
    moments.first += thickness * first;
    moments.second.topLeftCorner<2, 2>() += thickness * slice.second;
    moments.second.col(2) += thickness * z * first;
    moments.second.row(2).head<2>() += thickness * z * slice.first;
  };
  const auto add_layer = [&](double below, double above, double inset, double grows) {
    // All slices of a layer with vertical walls are equal.
    const AreaMoments equal = grows == 0 ? slice_at(inset) : AreaMoments();
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double side : {-1, 1}) {
        const double x = side * Rule::abscissa()[i];
        if (x == 0 && side > 0) continue;
        const double z = (below + above) / 2 + x * (above - below) / 2;
        const double thickness = Rule::weights()[i] * (above - below) / 2;
        if (grows == 0) {
          add_slice(z, equal, thickness);
        } else {
          add_slice(z, slice_at(inset + grows * (z - below)), thickness);
        }
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

/// Returns the outline's arcs and corners at both ends of the vertical walls, and at both ends of a
/// bevelled prism. Arcs that turn right are left out, because they are in the hull of the other
/// arcs.
Extent PrismExtent(const BasePolygon& base, const Prism& prism) {
  Extent extent;
  const auto add = [&](double inset, double z) {
    for (const RoundedCorner& corner : base.CornersOf(0, inset)) {
      if (corner.sweep < 0) continue;
      for (const double height : {-z, z}) {
        AddLevelArc({corner.place.x(), corner.place.y(), height}, corner.radius, corner.from,
                    corner.sweep, extent);
      }
    }
  };
  add(0, prism.height / 2 - prism.bevel);
  if (prism.bevel > 0) add(prism.bevel, prism.height / 2);
  return extent;
}

/// Partitions an area into convex polygons, and adds a piece between -z and z for each polygon.
void AddPieces(const Area& area, double z, std::vector<ConvexPiece>& pieces) {
  for (const std::vector<Point2>& corners : MergedPolygonsOf(area))
    pieces.push_back({.mesh = Loft({{corners, -z}, {corners, z}})});
}

std::vector<ConvexPiece> PiecesOf(const BasePolygon& base, const Prism& prism) {
  const PrismSections sections = base.SectionsAt(prism.bevel, prism.facets, true);
  const double top = prism.height / 2;
  const double edge = top - prism.bevel;
  std::vector<ConvexPiece> pieces;
  if (prism.bevel > 0 && sections.middle.ends.size() == 1 && IsConvex(sections.middle.corners)) {
    const std::vector<Point2>& inner = sections.end.corners;
    const std::vector<Point2>& outer = sections.middle.corners;
    pieces.push_back({.mesh = Loft({{inner, -top}, {outer, -edge}, {outer, edge}, {inner, top}})});
    return pieces;
  }
  AddPieces(sections.middle, edge, pieces);
  // For a bevelled prism, adds pieces over the full height with the smaller cross section of the
  // ends. Together, all pieces omit only the bevelled edges.
  if (prism.bevel > 0) AddPieces(sections.end, top, pieces);
  return pieces;
}

/// Returns a convex prism with sharp edges as a single piece, nullopt for any other prism.
std::optional<Solid> PlainPrism(const Prism& prism) {
  if (!prism.holes.empty() || prism.round > 0 || prism.bevel > 0) return std::nullopt;
  std::optional<TriangleMesh> mesh = MakeConvexPrism(prism.polygon, prism.height);
  if (!mesh) return std::nullopt;
  std::vector<Point2> corners;
  for (std::size_t i = 0; i < mesh->vertices.size() / 2; ++i)
    corners.emplace_back(mesh->vertices[i].head<2>());
  const double height = prism.height;
  const AreaMoments base = MomentsOf(NodesOf(corners));
  Moments moments;
  moments.volume = height * base.area;
  moments.first.head<2>() = height * base.first;
  moments.second.topLeftCorner<2, 2>() = height * base.second;
  moments.second(2, 2) = height * height * height / 12 * base.area;
  Solid solid;
  solid.pieces.push_back({.mesh = *std::move(mesh)});
  solid.mass = MassOf(moments, Eigen::Vector3d::Zero());
  return solid;
}

}  // namespace

std::optional<Solid> Make(const Prism& prism, Fault& fault) {
  if (!prism.holes_x.empty() || !prism.holes_y.empty()) {
    const std::optional<BasePolygon> cut = BasePolygonOf(prism, fault);
    return cut ? MakeCutPrism(prism, *cut, fault) : std::nullopt;
  }
  std::optional<Solid> plain = PlainPrism(prism);
  // Without a texture, no render mesh is needed, because MuJoCo also renders the piece. The mesh of
  // the piece has no texture coordinates.
  if (plain && prism.texture.unit == TextureMapping::Unit::kNone) return plain;
  const std::optional<BasePolygon> base = BasePolygonOf(prism, fault);
  if (!base) return plain;
  Solid solid;
  const PrismSections sections = base->SectionsAt(prism.bevel, CornerSegments(prism), false);
  solid.render_mesh = MakeExtrusionMesh(prism, sections);
  solid.pieces = PiecesOf(*base, prism);
  solid.mass = MassOf(*base, prism.height, prism.bevel);
  if (prism.round > 0 || prism.bevel > 0) solid.extent = PrismExtent(*base, prism);
  return solid;
}

}  // namespace mjforge::solid
