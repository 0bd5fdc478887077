// Sums volumes (or areas) and moments over the faces of a compiled mesh, and computes the box with
// the same inertia.
#include "mjforge/backport/mesh_measure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace mjforge::backport {
namespace {

using Vector = std::array<double, 3>;
using Matrix = std::array<mjtNum, 9>;

constexpr std::pair<std::string_view, MeshInertiaKind> kKinds[] = {
    {"legacy", MeshInertiaKind::kLegacy},
    {"exact", MeshInertiaKind::kExact},
    {"convex", MeshInertiaKind::kConvex},
    {"shell", MeshInertiaKind::kShell}};

Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector Difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Returns the vertex indices of the faces of a mesh, or of its convex hull if `of_hull` is true
/// and the mesh has a hull. In mjModel::mesh_graph, a hull begins with the numbers of its vertices
/// and faces, three numbers per vertex, and three numbers per face; then come the vertex indices of
/// the faces.
std::span<const int> FacesOf(const mjModel& m, int mesh, bool of_hull) {
  const auto at = [](const int* first, int offset) {
    return first + static_cast<std::ptrdiff_t>(offset);
  };
  const auto span = [](const int* first, int faces) {
    return std::span(first, static_cast<std::size_t>(3) * static_cast<std::size_t>(faces));
  };
  if (!of_hull || m.mesh_graphadr[mesh] < 0)
    return span(at(m.mesh_face, 3 * m.mesh_faceadr[mesh]), m.mesh_facenum[mesh]);
  const int* graph = at(m.mesh_graph, m.mesh_graphadr[mesh]);
  return span(at(graph, 2 + 3 * graph[0] + 3 * graph[1]), graph[1]);
}

/// Volume, first and second moments, about a common apex, of the pyramids from the apex to each
/// face; for a shell, area and moments of the faces.
struct Sums {
  double size = 0;
  Vector first = {};
  Matrix second = {};

  // Adds a face whose corners are relative to the apex. Moments of tetrahedra: Tonon, "Explicit
  // exact formulas for the 3-D tetrahedron inertia tensor in terms of its vertex coordinates"
  // (2004). The moments of a triangle have the same form.
  void Add(const std::array<Vector, 3>& corners, MeshInertiaKind kind) {
    const auto& [a, b, c] = corners;
    const bool shell = kind == MeshInertiaKind::kShell;
    double weight = Dot(a, Cross(b, c)) / 6;
    if (kind == MeshInertiaKind::kLegacy) weight = std::abs(weight);
    if (shell) {
      const Vector normal = Cross(Difference(b, a), Difference(c, a));
      weight = std::sqrt(Dot(normal, normal)) / 2;
    }
    size += weight;
    for (std::size_t i = 0; i < 3; ++i) {
      const double sum = a[i] + b[i] + c[i];
      first[i] += weight / (shell ? 3 : 4) * sum;
      for (std::size_t j = 0; j < 3; ++j) {
        second[3 * i + j] += weight / (shell ? 12 : 20) *
                             (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum * (a[j] + b[j] + c[j]));
      }
    }
  }
};

/// Returns the sums over the faces of a mesh (kShell), or over the pyramids from `apex` to the
/// faces (other kinds); for kConvex, over those of the convex hull.
Sums AddUp(const mjModel& m, int mesh, MeshInertiaKind kind, const Vector& apex) {
  Sums sums;
  const float* vertices = m.mesh_vert + static_cast<std::ptrdiff_t>(3) * m.mesh_vertadr[mesh];
  const std::span<const int> faces = FacesOf(m, mesh, kind == MeshInertiaKind::kConvex);
  for (std::size_t face = 0; face < faces.size(); face += 3) {
    std::array<Vector, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const float* vertex = vertices + static_cast<std::ptrdiff_t>(3) * faces[face + i];
      corners[i] = Difference({vertex[0], vertex[1], vertex[2]}, apex);
    }
    sums.Add(corners, kind);
  }
  return sums;
}

/// Returns the centre of mass of `sums`, whose moments are about `apex`.
Vector CentreOf(const Sums& sums, const Vector& apex) {
  Vector centre = apex;
  for (std::size_t i = 0; i < 3; ++i) centre[i] += sums.first[i] / sums.size;
  return centre;
}

// Sets `measured.quat` to the principal axes, and returns the second moments along these axes.
// `sums` must be about the centre of mass. The principal moments of inertia are in decreasing
// order, the order of MuJoCo.
std::array<mjtNum, 3> Diagonalize(const Sums& sums, MeshMeasure& measured) {
  Matrix inertia = {};
  for (std::size_t i = 0; i < 9; ++i) inertia[i] = -sums.second[i];
  const double trace = -(inertia[0] + inertia[4] + inertia[8]);
  for (std::size_t i = 0; i < 9; i += 4) inertia[i] += trace;
  std::array<mjtNum, 3> moments;
  Matrix axes;
  mju_eig3(moments.data(), axes.data(), measured.quat.data(), inertia.data());
  std::array<mjtNum, 3> squares;
  for (std::size_t i = 0; i < 3; ++i) squares[i] = trace - moments[i];
  return squares;
}

}  // namespace

std::optional<MeshInertiaKind> KindNamed(std::string_view word) {
  const auto* found =
      std::ranges::find(kKinds, word, &std::pair<std::string_view, MeshInertiaKind>::first);
  if (found == std::end(kKinds)) return std::nullopt;
  return found->second;
}

MeshMeasure Measure(const mjModel& m, int mesh, MeshInertiaKind kind) {
  MeshMeasure measured;
  // Uses the same apex for the pyramids as MuJoCo, because the sums over an open mesh depend on the
  // apex: the centroid of the surface to find the centre of mass, and then the centre of mass to
  // find mass and inertia.
  if (kind != MeshInertiaKind::kLegacy) {
    Vector apex = {};
    for (const MeshInertiaKind step : {MeshInertiaKind::kShell, kind}) {
      const Sums sums = AddUp(m, mesh, step, apex);
      measured.size = sums.size;
      if (!(sums.size > 0)) return measured;
      apex = CentreOf(sums, apex);
    }
    measured.pos = apex;
  }
  const Sums sums = AddUp(m, mesh, kind, measured.pos);
  measured.size = sums.size;
  if (!(sums.size > 0)) return measured;
  const Matrix& second = sums.second;
  std::array<mjtNum, 3> squares = {second[0], second[4], second[8]};
  if (kind != MeshInertiaKind::kLegacy) squares = Diagonalize(sums, measured);
  // Computes half sizes from mean squares: a coordinate in a box with half size s has the mean
  // square s^2 / 3. MuJoCo 2.2 rejects a box without thickness, and, because of rounding, a box
  // whose thickness is less than the share kThinnest of its length.
  constexpr double kThinnest = 1e-6;
  for (std::size_t i = 0; i < 3; ++i)
    measured.box[i] = std::sqrt(std::max(0.0, 3 * squares[i] / sums.size));
  const double thinnest = kThinnest * *std::ranges::max_element(measured.box);
  for (mjtNum& size : measured.box) size = std::max(size, thinnest);
  return measured;
}

}  // namespace mjforge::backport
