#include <algorithm>
#include <cmath>

#include "mjforge/solid/look.h"

namespace mjforge::solid {
namespace {

class PrismLooker {
 public:
  explicit PrismLooker(const PrismLook& input) : in_(input) {
    const Area& middle = in_.levels.middle;
    for (const Point& p : middle.corners) box_.extend(p);
    const bool by_metre = in_.texture.unit == Texture::Unit::kMetre;
    cap_scale_ = in_.texture.repeat;
    side_scale_ = in_.texture.repeat;
    if (by_metre) return;
    cap_scale_ = cap_scale_.cwiseQuotient(box_.sizes());
    double around = 0;  // of the outline
    const auto [first, count] = middle.Loop(0);
    for (std::size_t i = 0; i < count; ++i)
      around += (middle.corners[(i + 1) % count] - middle.corners[i]).norm();
    side_scale_ = side_scale_.cwiseQuotient(Point(around, in_.height));
  }

  Surface Run() {
    const double top = in_.height / 2;
    const double edge = top - in_.bevel;
    const Area& middle = in_.levels.middle;
    const Area& end = in_.levels.end;
    AddCaps();
    if (in_.bevel > 0) {
      AddBand({end, -top}, {middle, -edge}, -std::sqrt(0.5));
      AddBand({middle, edge}, {end, top}, std::sqrt(0.5));
    }
    AddBand({middle, -edge}, {middle, edge}, 0);
    return std::move(surface_);
  }

 private:
  struct Level {
    const Area& area;
    double z;
  };

  int AddVertex(const Point& p, double z, const Eigen::Vector3d& normal, const Point& texcoord) {
    surface_.vertices.emplace_back(p.x(), p.y(), z);
    surface_.normals.push_back(normal);
    surface_.texcoords.push_back(texcoord);
    return static_cast<int>(surface_.vertices.size()) - 1;
  }

  void AddCaps() {
    const Area& area = in_.levels.end;
    const std::vector<std::array<int, 3>> triangles = PartitionOf(area).triangles;
    for (const double side : {-1.0, 1.0}) {
      const int first = static_cast<int>(surface_.vertices.size());
      for (const Point& p : area.corners) {
        const Point at(p.x() - box_.min().x(), box_.max().y() - p.y());
        AddVertex(p, side * in_.height / 2, {0, 0, side}, at.cwiseProduct(cap_scale_));
      }
      for (std::array<int, 3> triangle : triangles) {
        if (side < 0) std::swap(triangle[1], triangle[2]);
        for (int& corner : triangle) corner += first;
        surface_.triangles.push_back(triangle);
      }
    }
  }

  /// The sides between two levels; `up`: the z of their normals.
  void AddBand(const Level& below, const Level& above, double up) {
    for (std::size_t loop = 0; loop < below.area.ends.size(); ++loop)
      AddLoop(below, above, up, loop);
  }

  void AddLoop(const Level& below, const Level& above, double up, std::size_t loop) {
    const Area& middle = in_.levels.middle;
    const auto [first, count] = middle.Loop(loop);
    const auto side = [&, first = first, count = count](std::size_t i) {
      return Point(middle.corners[first + (i + 1) % count] - middle.corners[first + i % count]);
    };
    const auto outward = [&](std::size_t i) {
      const Point way = side(i).normalized();
      return Point(way.y(), -way.x());
    };
    const auto is_smooth = [&, count = count](std::size_t i) {  // at the corner where side i begins
      return outward(i + count - 1).dot(outward(i)) >= std::cos(in_.crease);
    };
    double along = 0;
    std::pair<int, int> very_first;
    std::pair<int, int> last;
    // Where the texture ends, it begins again.
    const bool joins = in_.texture.unit == Texture::Unit::kNone && is_smooth(0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto add = [&, first = first, count = count](std::size_t corner, std::size_t beside) {
        Point flat = outward(i);
        if (is_smooth(corner)) flat = (flat + outward(beside)).normalized();
        flat *= std::sqrt(1 - up * up);
        const Eigen::Vector3d normal(flat.x(), flat.y(), up);
        const std::size_t at = first + corner % count;
        const auto vertex = [&](const Level& level) {
          const Point texcoord(along, in_.height / 2 - level.z);
          return AddVertex(level.area.corners[at], level.z, normal,
                           texcoord.cwiseProduct(side_scale_));
        };
        const int low = vertex(below);
        return std::pair(low, vertex(above));
      };
      const auto from = i > 0 && is_smooth(i) ? last : add(i, i + count - 1);
      if (i == 0) very_first = from;
      along += side(i).norm();
      last = joins && i + 1 == count ? very_first : add(i + 1, i + 1);
      AddQuad(from.first, last.first, last.second, from.second, surface_);
    }
  }

  const PrismLook& in_;
  Eigen::AlignedBox2d box_;
  Point cap_scale_;
  Point side_scale_;
  Surface surface_;
};

}  // namespace

Surface Make(const PrismLook& look) {
  Surface surface = PrismLooker(look).Run();
  if (look.texture.unit == Texture::Unit::kNone) surface.texcoords.clear();
  RoundForText(surface);
  return surface;
}

}  // namespace mjforge::solid
