// Prisms with holes along x or y: checks, convex pieces and mass.

#include "mjforge/solid/cut_prism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/solid/convex_cells.h"
#include "mjforge/solid/convex_partition.h"
#include "mjforge/solid/hole_outlines.h"
#include "mjforge/solid/joined_polyhedra.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/polytope.h"

namespace mjforge::solid {
namespace {

constexpr double kNear = 1e-10;            // rounding errors, as a share of the prism's size
constexpr std::size_t kMostPieces = 1000;  // limits time and memory

/// Returns the rectangle around the prism, seen along an axis, with the holes along this axis.
std::optional<Area> SideSection(const Prism& prism, const SectionPlane& plane,
                                const HoleGroup& group, Fault& fault) {
  const Eigen::AlignedBox3d box = BoundsOf(prism);
  const auto corner = [&](const Eigen::Vector3d& p) { return Point2(p[plane.u], p[plane.v]); };
  const Point2 low = corner(box.min());
  const Point2 high = corner(box.max());
  const std::vector<Point2> points = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  const std::optional<Outline> around = OutlineOf(points, fault);
  const auto holes = around ? HolesIn(*around, group, fault) : std::nullopt;
  if (!holes) return std::nullopt;
  Area area(around->corners);
  for (const Outline& hole : *holes) area.Add(hole.corners);
  return area;
}

std::optional<CutSections> SectionsOf(const Prism& prism, const BasePolygon& base, Fault& fault) {
  CutSections sections;
  HoleGroup group{.outlines = {}, .first_loop = 1 + prism.holes.size()};
  for (const Outline& loop : base.loops) {
    sections[2].Add(loop.corners);
    group.other_points += loop.corners.size();
  }
  constexpr std::string_view kAxes[] = {"x", "y"};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    group.outlines = axis == 0 ? prism.holes_x : prism.holes_y;
    group.along = kAxes[axis];
    std::optional<Area> area = SideSection(prism, kSectionPlanes[axis], group, fault);
    if (!area) return std::nullopt;
    group.first_loop += group.outlines.size();
    for (const std::vector<Point2>& hole : group.outlines) group.other_points += hole.size();
    sections[axis] = *std::move(area);
  }
  return sections;
}

/// Returns the outline or one hole of an area as an area without holes.
Area LoopOf(const Area& area, std::size_t loop) {
  const auto [first, count] = area.Loop(loop);
  const auto begin = area.corners.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<Point2> corners(begin, begin + static_cast<std::ptrdiff_t>(count));
  if (loop > 0) std::ranges::reverse(corners);  // holes are clockwise
  return Area(corners);
}

/// Returns the extrusions of a convex partition of the prism's polygon without its holes.
std::vector<Polytope> UncutPieces(const Area& area, double height) {
  std::vector<Polytope> pieces;
  for (const std::vector<Point2>& polygon : ConvexPolygonsOf(LoopOf(area, 0))) {
    std::vector<Eigen::Vector3d> vertices;
    for (const double z : {-height / 2, height / 2}) {
      for (const Point2& corner : polygon) vertices.push_back(kSectionPlanes[2].At(corner, z));
    }
    Fault unused;
    std::optional<Polytope> piece = HullOf(vertices, unused);
    if (piece) pieces.push_back(*std::move(piece));
  }
  return pieces;
}

/// Cuts the holes of a section into the pieces. Returns false if there are too many pieces.
bool CutHoles(const Area& section, const SectionPlane& plane, double near,
              std::vector<Polytope>& pieces) {
  for (std::size_t loop = 1; loop < section.ends.size(); ++loop) {
    for (Cell& cell : CellsOf(LoopOf(section, loop), plane)) {
      // Cuts along level sides first, so that crossing holes leave slabs. Rounding errors do not
      // change the order, because the keys have single precision.
      std::ranges::stable_sort(cell.sides, std::ranges::greater(), [](const HalfSpace& side) {
        return static_cast<float>(std::abs(side.normal.z()));
      });
      if (!Subtract(cell, pieces, near, kMostPieces)) return false;
    }
  }
  JoinPolyhedra(pieces, near);
  return true;
}

Mass MassOf(const std::vector<Polytope>& pieces) {
  Moments sum;
  for (const Polytope& piece : pieces) {
    const Mass mass = RoundedMass(piece, 0);
    sum.volume += mass.volume;
    sum.first += mass.volume * mass.center;
    sum.second += mass.inertia.trace() / 2 * Eigen::Matrix3d::Identity() - mass.inertia +
                  mass.volume * mass.center * mass.center.transpose();
  }
  return MassOf(sum, Eigen::Vector3d::Zero());
}

/// Returns a box for a polyhedron with faces perpendicular to the axes, because boxes have more
/// contact points than meshes; otherwise a mesh.
ConvexPiece PieceOf(const Polytope& polytope) {
  bool is_box = polytope.vertices.size() == 8 && polytope.faces.size() == 6;
  const Eigen::AlignedBox3d box = BoxAround(polytope.vertices);
  for (const Polytope::Face& face : polytope.faces)
    is_box = is_box && face.normal.cwiseAbs().maxCoeff() >= 1 - kNear;
  if (!is_box) return {.mesh = MeshOf(polytope)};
  return {.type = ConvexPiece::Type::kBox, .size = box.sizes() / 2, .p = box.center()};
}

}  // namespace

Eigen::AlignedBox3d BoundsOf(const Prism& prism) {
  Eigen::AlignedBox3d box;
  for (const Point2& p : prism.polygon) {
    box.extend(kSectionPlanes[2].At(p, -prism.height / 2));
    box.extend(kSectionPlanes[2].At(p, prism.height / 2));
  }
  return box;
}

std::optional<Solid> MakeCutPrism(const Prism& prism, const BasePolygon& base, Fault& fault) {
  if (prism.round > 0 || prism.bevel > 0)
    return Fail(fault, "has holes along x or y, so that it cannot be rounded or bevelled");
  const std::optional<CutSections> sections = SectionsOf(prism, base, fault);
  if (!sections) return std::nullopt;
  const double near = kNear * BoundsOf(prism).diagonal().norm();
  std::vector<Polytope> pieces = UncutPieces((*sections)[2], prism.height);
  for (const std::size_t axis : {2, 0, 1}) {
    if (CutHoles((*sections)[axis], kSectionPlanes[axis], near, pieces)) continue;
    return Fail(fault,
                fmt::format("is cut into more than {} convex pieces by its holes", kMostPieces));
  }
  if (const std::size_t parts = CountSeparateParts(pieces, near); parts > 1)
    return Fail(fault, fmt::format("falls apart: its holes cut it into {} parts", parts));
  Solid solid;
  solid.render_mesh = MakeCutMesh(prism, *sections);
  for (const Polytope& piece : pieces) solid.pieces.push_back(PieceOf(piece));
  solid.mass = MassOf(pieces);
  return solid;
}

}  // namespace mjforge::solid
