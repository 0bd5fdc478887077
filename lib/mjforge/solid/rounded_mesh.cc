// Triangle mesh of a polytope with rounded edges: faces, cylinder arcs, spherical patches.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mjforge/solid/half_edges.h"
#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

/// Interpolates between two unit vectors along their great arc.
Vector3d Slerp(const Vector3d& a, const Vector3d& b, double share) {
  const double angle = AngleBetween(a, b);
  if (angle < 1e-9) return (a + share * (b - a)).normalized();
  return (std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

class RoundedMesher {
 public:
  RoundedMesher(const Polytope& polytope, double radius, int per_turn)
      : polytope_(polytope), edges_(polytope), radius_(radius) {
    double largest = 0;
    for (const auto& [a, b] : edges_.All()) {
      const double angle =
          AngleBetween(NormalOf(edges_.FaceAt(a, b)), NormalOf(edges_.FaceAt(b, a)));
      largest = std::max(largest, angle);
    }
    const double steps = std::ceil(largest * per_turn / (2 * std::numbers::pi) - 1e-9);
    steps_ = std::max(1, static_cast<int>(steps));
  }

  TriangleMesh Run() {
    for (int face = 0; face < static_cast<int>(polytope_.faces.size()); ++face) AddFace(face);
    for (const auto& [a, b] : edges_.All()) AddEdge(a, b);
    for (int vertex = 0; vertex < static_cast<int>(polytope_.vertices.size()); ++vertex)
      AddVertex(vertex);
    return std::move(mesh_);
  }

 private:
  const Vector3d& NormalOf(int face) const {
    return polytope_.faces[static_cast<std::size_t>(face)].normal;
  }

  int Add(int vertex, const Vector3d& normal) {
    mesh_.vertices.emplace_back(polytope_.vertices[static_cast<std::size_t>(vertex)] +
                                radius_ * normal);
    mesh_.normals.push_back(normal);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  /// Returns the mesh vertices around a polytope vertex, along the arc from the normal of one face
  /// to the normal of another.
  std::vector<int> Arc(int vertex, int from, int to) {
    if (from > to) {
      std::vector<int> arc = Arc(vertex, to, from);
      std::ranges::reverse(arc);
      return arc;
    }
    std::vector<int>& arc = arcs_[{vertex, from, to}];
    if (arc.empty()) {
      arc.push_back(Arc(vertex, from));
      for (int i = 1; i < steps_; ++i)
        arc.push_back(
            Add(vertex, Slerp(NormalOf(from), NormalOf(to), static_cast<double>(i) / steps_)));
      arc.push_back(Arc(vertex, to));
    }
    return arc;
  }

  /// Returns the mesh vertex at a polytope vertex, in the direction of a face's normal.
  int Arc(int vertex, int face) {
    const auto [at, is_new] = ends_.try_emplace({vertex, face}, 0);
    if (is_new) at->second = Add(vertex, NormalOf(face));
    return at->second;
  }

  void AddTriangle(int a, int b, int c) { mesh_.triangles.push_back({a, b, c}); }

  void AddFace(int face) {
    const std::vector<int>& corners = polytope_.faces[static_cast<std::size_t>(face)].corners;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      // Calls Arc() in separate statements, because the order in which a call's arguments add
      // vertices depends on the processor.
      const int c = Arc(corners[i + 1], face);
      const int b = Arc(corners[i], face);
      AddTriangle(Arc(corners[0], face), b, c);
    }
  }

  void AddEdge(int a, int b) {
    // The arcs run from right to left, seen from outside with b above a.
    const int left = edges_.FaceAt(a, b);
    const int right = edges_.FaceAt(b, a);
    const std::vector<int> below = Arc(a, right, left);
    const std::vector<int> above = Arc(b, right, left);
    for (std::size_t i = 0; i + 1 < below.size(); ++i)
      AddQuad(below[i], above[i], above[i + 1], below[i + 1], mesh_);
  }

  void AddVertex(int vertex) {
    const std::vector<int> faces = edges_.FacesAround(vertex);
    if (IsSharp(faces)) return AddTip(vertex, faces);
    for (std::size_t i = 1; i + 1 < faces.size(); ++i) {
      const std::vector<int> last = Arc(vertex, faces[i], faces[i + 1]);
      const std::vector<int> right = Arc(vertex, faces[0], faces[i + 1]);
      AddPatch(vertex, Arc(vertex, faces[0], faces[i]), right, last);
    }
  }

  /// Returns true if any two face normals are more than 104 degrees apart, too far for patches that
  /// are interpolated between them.
  bool IsSharp(const std::vector<int>& faces) const {
    constexpr double kCosine = -0.25;
    return std::ranges::any_of(faces, [&](int a) {
      return std::ranges::any_of(faces,
                                 [&](int b) { return NormalOf(a).dot(NormalOf(b)) < kCosine; });
    });
  }

  /// Adds the rounded tip at a vertex as patches around the mean normal.
  void AddTip(int vertex, const std::vector<int>& faces) {
    // Mean normal over the spherical polygon of the face normals, by the divergence theorem on the
    // sphere.
    Vector3d middle = Vector3d::Zero();
    const std::size_t count = faces.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d& a = NormalOf(faces[i]);
      const Vector3d& b = NormalOf(faces[(i + 1) % count]);
      const Vector3d axis = a.cross(b);
      if (axis.norm() > 0) middle += AngleBetween(a, b) * axis.normalized();
    }
    middle.normalize();
    const int center = Add(vertex, middle);
    std::vector<std::vector<int>> spokes;
    for (const int face : faces) {
      std::vector<int>& spoke = spokes.emplace_back(1, center);
      for (int i = 1; i < steps_; ++i)
        spoke.push_back(
            Add(vertex, Slerp(middle, NormalOf(face), static_cast<double>(i) / steps_)));
      spoke.push_back(Arc(vertex, face));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      AddPatch(vertex, spokes[i], spokes[next], Arc(vertex, faces[i], faces[next]));
    }
  }

  /// Adds the spherical triangle between two arcs with a common beginning and the arc between their
  /// ends, in rows of one, two and more segments.
  void AddPatch(int vertex, const std::vector<int>& left, const std::vector<int>& right,
                const std::vector<int>& last) {
    std::vector<int> previous = {left[0]};
    for (int k = 1; k <= steps_; ++k) {
      const auto row = static_cast<std::size_t>(k);
      std::vector<int> now = last;
      if (k < steps_) {
        now = {left[row]};
        const Vector3d from = mesh_.normals[static_cast<std::size_t>(left[row])];
        const Vector3d to = mesh_.normals[static_cast<std::size_t>(right[row])];
        for (int i = 1; i < k; ++i)
          now.push_back(Add(vertex, Slerp(from, to, static_cast<double>(i) / k)));
        now.push_back(right[row]);
      }
      for (std::size_t i = 0; i < row; ++i) {
        AddTriangle(previous[i], now[i], now[i + 1]);
        if (i + 1 < row) AddTriangle(previous[i], now[i + 1], previous[i + 1]);
      }
      previous = now;
    }
  }

  const Polytope& polytope_;
  HalfEdges edges_;
  double radius_;
  int steps_ = 1;
  TriangleMesh mesh_;
  std::map<std::pair<int, int>, int> ends_;              // mesh vertex by vertex and face
  std::map<std::array<int, 3>, std::vector<int>> arcs_;  // mesh vertices by vertex and two faces
};

}  // namespace

TriangleMesh RoundedMesh(const Polytope& polytope, double radius, int per_turn) {
  return RoundedMesher(polytope, radius, per_turn).Run();
}

}  // namespace mjforge::solid
