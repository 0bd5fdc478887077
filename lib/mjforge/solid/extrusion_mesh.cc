// Render mesh of a prism: caps, sides and bevels, with normals and texture coordinates.

#include <algorithm>
#include <cmath>

#include "mjforge/solid/prism_mesh.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

class ExtrusionMesher {
 public:
  ExtrusionMesher(const Prism& prism, const PrismSections& sections)
      : prism_(prism), sections_(sections), surface_(prism, sections.middle) {}

  TriangleMesh Run() {
    const double top = prism_.height / 2;
    const double edge = top - prism_.bevel;
    const Area& middle = sections_.middle;
    const Area& end = sections_.end;
    surface_.AddCaps(end);
    if (prism_.bevel > 0) {
      AddBand({end, -top}, {middle, -edge}, -std::sqrt(0.5));
      AddBand({middle, edge}, {end, top}, std::sqrt(0.5));
    }
    AddBand({middle, -edge}, {middle, edge}, 0);
    // Viewers draw translucent meshes in the order of their faces, so faces in holes come first.
    surface_.mesh.triangles.insert(surface_.mesh.triangles.begin(), in_holes_.begin(),
                                   in_holes_.end());
    return std::move(surface_.mesh);
  }

 private:
  struct Section {
    const Area& area;
    double z;
  };

  /// Adds the sides between two sections. `up` is the z component of the normals.
  void AddBand(const Section& below, const Section& above, double up) {
    for (std::size_t loop = 0; loop < below.area.ends.size(); ++loop) {
      const auto before = static_cast<std::ptrdiff_t>(surface_.mesh.triangles.size());
      AddLoop(below, above, up, loop);
      if (loop == 0) continue;  // loop 0 is the outline
      const auto begin = surface_.mesh.triangles.begin() + before;
      in_holes_.insert(in_holes_.end(), begin, surface_.mesh.triangles.end());
      surface_.mesh.triangles.erase(begin, surface_.mesh.triangles.end());
    }
  }

  void AddLoop(const Section& below, const Section& above, double up, std::size_t loop) {
    const std::vector<Strip> strips = StripsOf(sections_.middle, loop, prism_.crease);
    const std::size_t count = strips.size();
    const std::size_t first = sections_.middle.Loop(loop).first;
    const auto add = [&](std::size_t corner, const Point2& blended, double along) {
      const Point2 flat = blended * std::sqrt(1 - up * up);
      const Eigen::Vector3d normal(flat.x(), flat.y(), up);
      const auto vertex = [&](const Section& section) {
        const Point2 unrolled(along, prism_.height / 2 - section.z);
        const Point2& p = section.area.corners[first + corner % count];
        return surface_.AddSideVertex({p.x(), p.y(), section.z}, normal, unrolled);
      };
      const int low = vertex(below);
      return std::pair(low, vertex(above));
    };
    std::pair<int, int> very_first;
    std::pair<int, int> last;
    // Vertices at the seam of a texture differ in their texture coordinates.
    const bool joins = prism_.texture.unit == TextureMapping::Unit::kNone && strips[0].is_smooth;
    for (std::size_t i = 0; i < count; ++i) {
      const Strip& strip = strips[i];
      const double end = strip.along + (strip.to - strip.from).norm();
      const auto from = i > 0 && strip.is_smooth ? last : add(i, strip.normal_from, strip.along);
      if (i == 0) very_first = from;
      last = joins && i + 1 == count ? very_first : add(i + 1, strip.normal_to, end);
      AddQuad(from.first, last.first, last.second, from.second, surface_.mesh);
    }
  }

  const Prism& prism_;
  const PrismSections& sections_;
  PrismMesh surface_;
  std::vector<std::array<int, 3>> in_holes_;
};

}  // namespace

TriangleMesh MakeExtrusionMesh(const Prism& prism, const PrismSections& sections) {
  TriangleMesh mesh = ExtrusionMesher(prism, sections).Run();
  if (prism.texture.unit == TextureMapping::Unit::kNone) mesh.texcoords.clear();
  RoundCoordinates(mesh);
  return mesh;
}

}  // namespace mjforge::solid
