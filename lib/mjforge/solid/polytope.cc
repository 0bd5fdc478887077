#include "mjforge/solid/polytope.h"

#include <array>
#include <cstdio>
#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace mjforge::solid {
namespace {

// Qhull's state, with its memory.
class Qhull {
 public:
  Qhull() { qh_zero(&state_, nullptr); }
  ~Qhull() {
    qh_freeqhull(&state_, qh_ALL);
    int left = 0;
    int left_bytes = 0;
    qh_memfreeshort(&state_, &left, &left_bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// False if the points are flat. `coordinates` must outlive this.
  bool Run(std::vector<double>& coordinates) {
    char command[] = "qhull";
    // What it says of flat points is said better where they stand.
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::fopen("/dev/null", "w"),
                                                                  std::fclose);
    return qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                        False, command, nullptr, nowhere.get()) == 0;
  }

  /// With each point's index.
  std::vector<Polytope::Face> Faces() {
    std::vector<Polytope::Face> faces;
    qhT* qh = &state_;  // by this name Qhull's macros know it
    facetT* facet = nullptr;
    FORALLfacets {
      Polytope::Face face{{}, Eigen::Vector3d(facet->normal)};
      setT* corners = qh_facet3vertex(qh, facet);
      vertexT* vertex = nullptr;
      vertexT** vertexp = nullptr;
      FOREACHvertex_(corners) face.corners.push_back(qh_pointid(qh, vertex->point));
      qh_settempfree(qh, &corners);
      faces.push_back(std::move(face));
    }
    return faces;
  }

 private:
  qhT state_;
};

Eigen::Vector3d NormalOf(const std::vector<Eigen::Vector3d>& vertices,
                         const std::vector<int>& corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // Newell
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = vertices[static_cast<std::size_t>(corners[i])];
    const Eigen::Vector3d& b =
        vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])];
    normal += a.cross(b);
  }
  return normal.normalized();
}

}  // namespace

std::optional<Polytope> HullOf(std::span<const Eigen::Vector3d> points, Fault& fault) {
  fault = {};
  if (points.size() < 4 || points.size() > kMostPoints) {
    fault.message = points.size() < 4 ? "needs at least 4 points" : "has more than 1000 points";
    return std::nullopt;
  }
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
  Qhull qhull;
  if (!qhull.Run(coordinates)) {
    fault.message = "has no volume: all points lie in a plane";
    return std::nullopt;
  }
  Polytope hull;
  std::vector<int> indices(points.size(), -1);
  for (Polytope::Face& face : qhull.Faces()) {
    for (int& corner : face.corners) {
      int& index = indices[static_cast<std::size_t>(corner)];
      if (index < 0) {
        index = static_cast<int>(hull.vertices.size());
        hull.vertices.push_back(points[static_cast<std::size_t>(corner)]);
      }
      corner = index;
    }
    const Eigen::Vector3d normal = NormalOf(hull.vertices, face.corners);
    if (normal.dot(face.normal) < 0) std::ranges::reverse(face.corners);
    face.normal = NormalOf(hull.vertices, face.corners);
    hull.faces.push_back(std::move(face));
  }
  return hull;
}

Polytope BoxOf(const Eigen::Vector3d& half) {
  Polytope box;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    box.vertices.emplace_back(half.cwiseProduct(sign));
  }
  const std::array<std::array<int, 4>, 6> faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& corners : faces) {
    std::vector<int> face(corners.begin(), corners.end());
    const Eigen::Vector3d normal = NormalOf(box.vertices, face);
    box.faces.push_back({std::move(face), normal});
  }
  return box;
}

Piece PieceOf(const Polytope& polytope) {
  Piece piece;
  piece.vertices = polytope.vertices;
  for (const Polytope::Face& face : polytope.faces) {
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
      piece.triangles.push_back({face.corners[0], face.corners[i], face.corners[i + 1]});
  }
  return piece;
}

}  // namespace mjforge::solid
