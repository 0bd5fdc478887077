// Render mesh of a prism with holes along x or y, with normals and texture coordinates.

#include <algorithm>
#include <cmath>

#include "mjforge/solid/convex_cells.h"
#include "mjforge/solid/cut_prism.h"
#include "mjforge/solid/polytope.h"
#include "mjforge/solid/prism_mesh.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

// Distance from a face, as a share of the prism's size, at which the space on the inner or outer
// side of the face is tested.
constexpr double kBeside = 1e-8;

/// Rectangle that one side of an outline sweeps when the outline is extruded along its axis.
struct Strip {
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();
  Point2 outward = Point2::Zero();
  Point2 normal_from = Point2::Zero();  // blended with the neighbour's normal if the edge is smooth
  Point2 normal_to = Point2::Zero();
  double along = 0;  // length of the outline up to `from`
};

std::vector<Strip> StripsOf(const Area& area, std::size_t loop, double crease) {
  const auto [first, count] = area.Loop(loop);
  std::vector<Strip> strips(count);
  double along = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Strip& strip = strips[i];
    strip.from = area.corners[first + i];
    strip.to = area.corners[first + (i + 1) % count];
    const Point2 side = strip.to - strip.from;
    strip.outward = Point2(side.y(), -side.x()).normalized();
    strip.along = along;
    along += side.norm();
  }
  const auto blended = [&](const Point2& a, const Point2& b) {
    return a.dot(b) >= std::cos(crease) ? Point2((a + b).normalized()) : a;
  };
  for (std::size_t i = 0; i < count; ++i) {
    strips[i].normal_from = blended(strips[i].outward, strips[(i + count - 1) % count].outward);
    strips[i].normal_to = blended(strips[i].outward, strips[(i + 1) % count].outward);
  }
  return strips;
}

class CutMesher {
 public:
  CutMesher(const Prism& prism, const CutSections& sections)
      : prism_(prism), sections_(sections), surface_(prism, sections[2]) {
    for (const Point2& p : sections[2].corners) {
      box_.extend(Vector3d(p.x(), p.y(), -prism.height / 2));
      box_.extend(Vector3d(p.x(), p.y(), prism.height / 2));
    }
    beside_ = kBeside * box_.diagonal().norm();
    for (std::size_t axis = 0; axis < 3; ++axis)
      cells_[axis] = CellsOf(sections[axis], kSectionPlanes[axis]);
  }

  TriangleMesh Run() {
    surface_.AddCaps(sections_[2]);
    for (const std::size_t axis : {2, 0, 1}) {
      // Skips loop 0 of the sections along x and y, which is the rectangle around the prism.
      for (std::size_t loop = axis == 2 ? 0 : 1; loop < sections_[axis].ends.size(); ++loop) {
        for (const Strip& strip : StripsOf(sections_[axis], loop, prism_.crease))
          AddStrip(axis, strip);
      }
    }
    return std::move(surface_.mesh);
  }

 private:
  /// Adds the parts of a strip that are on the prism's surface, which are the parts inside of both
  /// other extrusions. If sides of several extrusions coincide, only the first of these extrusions,
  /// in the order z, x, y, adds its strip: a part of a later extrusion is left out if the space on
  /// its outer side is outside of an earlier extrusion.
  void AddStrip(std::size_t axis, const Strip& strip) {
    const SectionPlane& plane = kSectionPlanes[axis];
    const double low = box_.min()[plane.axis];
    const double high = box_.max()[plane.axis];
    std::vector<SpacePolygon> parts = {{plane.At(strip.from, low), plane.At(strip.to, low),
                                        plane.At(strip.to, high), plane.At(strip.from, high)}};
    const Vector3d outward = beside_ * plane.At(strip.outward, 0);
    for (const std::size_t other : {2, 0, 1}) {
      if (other != axis) parts = ClippedByCells(parts, cells_[other], -outward);
    }
    for (const std::size_t other : {2, 0}) {
      if (other == axis) break;
      parts = ClippedByCells(parts, cells_[other], outward);
    }
    for (const SpacePolygon& part : parts) AddPart(plane, strip, part);
  }

  void AddPart(const SectionPlane& plane, const Strip& strip, const SpacePolygon& corners) {
    const Point2 side = strip.to - strip.from;
    const int first = static_cast<int>(surface_.mesh.vertices.size());
    for (const Vector3d& p : corners) {
      const double share =
          (Point2(p[plane.u], p[plane.v]) - strip.from).dot(side) / side.squaredNorm();
      const Point2 normal = (1 - share) * strip.normal_from + share * strip.normal_to;
      const Point2 unrolled(strip.along + share * side.norm(),
                            box_.max()[plane.axis] - p[plane.axis]);
      surface_.AddSideVertex(p, plane.At(normal.normalized(), 0), unrolled);
    }
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const bool is_reversed = normal.dot(plane.At(strip.outward, 0)) < 0;
    for (int i = 1; i + 1 < static_cast<int>(corners.size()); ++i) {
      surface_.mesh.triangles.push_back(
          {first, first + i + (is_reversed ? 1 : 0), first + i + (is_reversed ? 0 : 1)});
    }
  }

  const Prism& prism_;
  const CutSections& sections_;
  Eigen::AlignedBox3d box_;
  double beside_ = 0;
  std::array<std::vector<Cell>, 3> cells_;
  PrismMesh surface_;
};

}  // namespace

TriangleMesh MakeCutMesh(const Prism& prism, const CutSections& sections) {
  TriangleMesh mesh = CutMesher(prism, sections).Run();
  const bool has_texture = prism.texture.unit != TextureMapping::Unit::kNone;
  if (!has_texture) mesh.texcoords.clear();
  RoundCoordinates(mesh);
  if (!has_texture) RemoveRepeats(mesh);
  return mesh;
}

}  // namespace mjforge::solid
