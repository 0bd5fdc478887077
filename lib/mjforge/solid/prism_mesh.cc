// Caps of prisms, and the scales of texture coordinates.

#include "mjforge/solid/prism_mesh.h"

#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {

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
  for (std::size_t i = 0; i < count; ++i) {
    Strip& strip = strips[i];
    Strip& before = strips[(i + count - 1) % count];
    strip.is_smooth = before.outward.dot(strip.outward) >= std::cos(crease);
    const Point2 blended = (before.outward + strip.outward).normalized();
    before.normal_to = strip.is_smooth ? blended : before.outward;
    strip.normal_from = strip.is_smooth ? blended : strip.outward;
  }
  return strips;
}

PrismMesh::PrismMesh(const Prism& prism, const Area& section)
    : prism_(prism), cap_scale_(prism.texture.repeat), side_scale_(prism.texture.repeat) {
  for (const Point2& p : section.corners) picture_.extend(OnPicture(prism.texture, p));
  if (prism.texture.unit == TextureMapping::Unit::kMetre) return;
  cap_scale_ = cap_scale_.cwiseQuotient(picture_.sizes());
  double around = 0;  // length of the outline
  const auto [first, count] = section.Loop(0);
  for (std::size_t i = 0; i < count; ++i)
    around += (section.corners[(i + 1) % count] - section.corners[i]).norm();
  side_scale_ = side_scale_.cwiseQuotient(Point2(around, prism.height));
}

int PrismMesh::AddVertex(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                         const Point2& texcoord) {
  mesh.vertices.push_back(p);
  mesh.normals.push_back(normal);
  mesh.texcoords.push_back(texcoord);
  return static_cast<int>(mesh.vertices.size()) - 1;
}

void PrismMesh::AddCaps(const Area& area) {
  const std::vector<std::array<int, 3>> triangles = PartitionOf(area).triangles;
  for (const double side : {-1.0, 1.0}) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Point2& p : area.corners) {
      const Point2 at = OnPicture(prism_.texture, p) - picture_.min();
      AddVertex({p.x(), p.y(), side * prism_.height / 2}, {0, 0, side},
                at.cwiseProduct(cap_scale_));
    }
    AddFace(triangles, first, side < 0, mesh);
  }
}

}  // namespace mjforge::solid
