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

class CutMesher {
 public:
  CutMesher(const Prism& prism, const CutSections& sections)
      : prism_(prism), sections_(sections), box_(BoundsOf(prism)), surface_(prism, sections[2]) {
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
