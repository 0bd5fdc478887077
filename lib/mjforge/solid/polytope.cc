// Convex polyhedra: hulls of points by Qhull, boxes, and triangulation of faces.

#include "mjforge/solid/polytope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace mjforge::solid {
namespace {

Eigen::Vector3d NormalOf(std::span<const Eigen::Vector3d> vertices,
                         const std::vector<int>& corners) {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // by Newell's method
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& a = vertices[static_cast<std::size_t>(corners[i])];
    const Eigen::Vector3d& b =
        vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])];
    normal += a.cross(b);
  }
  return normal.normalized();
}

// Owner of Qhull's state and memory.
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

  /// Computes the convex hull. Returns false if the points are almost coplanar. `coordinates` must
  /// outlive this object.
  bool Run(std::vector<double>& coordinates) {
    char command[] = "qhull";
    return qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                        False, command, nullptr, nowhere_.get()) == 0;
  }

  /// Returns the corners of each face, counter-clockwise from outside, as indices of the points.
  std::vector<std::vector<int>> Faces(std::span<const Eigen::Vector3d> points) {
    std::vector<std::vector<int>> faces;
    qhT* qh = &state_;  // Qhull's macros require this name
    facetT* facet = nullptr;
    FORALLfacets {
      std::vector<int>& face = faces.emplace_back();
      setT* corners = qh_facet3vertex(qh, facet);
      vertexT* vertex = nullptr;
      vertexT** vertexp = nullptr;
      FOREACHvertex_(corners) face.push_back(qh_pointid(qh, vertex->point));
      qh_settempfree(qh, &corners);
      if (NormalOf(points, face).dot(Eigen::Vector3d(facet->normal)) < 0)
        std::ranges::reverse(face);
    }
    return faces;
  }

 private:
  // Stream that discards Qhull's messages, because HullOf reports a fault. Qhull keeps a pointer to
  // this stream.
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere_{::fopencookie(nullptr, "w", {}),
                                                           std::fclose};
  qhT state_;
};

}  // namespace

std::optional<Polytope> HullOf(std::span<const Eigen::Vector3d> points, Fault& fault) {
  fault = {};
  if (points.size() < 4) return Fail(fault, "needs at least 4 points");
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& p : points) coordinates.insert(coordinates.end(), p.begin(), p.end());
  Qhull qhull;
  if (!qhull.Run(coordinates)) return Fail(fault, "has no volume: all points lie in a plane");
  std::vector<std::vector<int>> faces = qhull.Faces(points);
  // Sorts the faces, because Qhull's order depends on rounding, which differs between processors.
  for (std::vector<int>& face : faces)
    std::rotate(face.begin(), std::ranges::min_element(face), face.end());
  std::ranges::sort(faces);
  Polytope hull;
  std::vector<int> indices(points.size(), -1);
  for (std::vector<int>& face : faces) {
    for (int& corner : face) {
      int& index = indices[static_cast<std::size_t>(corner)];
      if (index < 0) {
        index = static_cast<int>(hull.vertices.size());
        hull.vertices.push_back(points[static_cast<std::size_t>(corner)]);
      }
      corner = index;
    }
    const Eigen::Vector3d normal = NormalOf(hull.vertices, face);
    hull.faces.push_back({std::move(face), normal});
  }
  return hull;
}

std::array<Eigen::Vector3d, 8> CornersOfBox(const Eigen::Vector3d& half_sizes) {
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d sign((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    corners[i] = half_sizes.cwiseProduct(sign);
  }
  return corners;
}

Polytope BoxOf(const Eigen::Vector3d& half_sizes) {
  Polytope box;
  const std::array corners = CornersOfBox(half_sizes);
  box.vertices.assign(corners.begin(), corners.end());
  const std::array<std::array<int, 4>, 6> faces = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& indices : faces) {
    std::vector<int> face(indices.begin(), indices.end());
    const Eigen::Vector3d normal = NormalOf(box.vertices, face);
    box.faces.push_back({std::move(face), normal});
  }
  return box;
}

TriangleMesh MeshOf(const Polytope& polytope) {
  TriangleMesh mesh;
  mesh.vertices = polytope.vertices;
  for (const Polytope::Face& face : polytope.faces) {
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
      mesh.triangles.push_back({face.corners[0], face.corners[i], face.corners[i + 1]});
  }
  return mesh;
}

ConvexPiece Primitive(ConvexPiece::Type type, const Eigen::Vector3d& size, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b) {
  ConvexPiece piece = {.type = type, .size = size, .p = (a + b) / 2};
  if (a != b) piece.q = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), b - a);
  return piece;
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace mjforge::solid
