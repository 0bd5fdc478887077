// Quasi-Monte Carlo estimate of the mass that overlapping parts count twice.
#include "mjforge/static_checks/mass_overlap.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

namespace mjforge::static_checks {
namespace {

// Number of points in the bounding box of a part with at least a tenth of the whole mass. Lighter
// parts get fewer points in proportion to their mass, because their errors matter less.
constexpr int kMostPoints = 2000;
constexpr int kFewestPoints = 100;
constexpr double kTenth = 0.1;
// Tolerance of the convexity test, as a share of the mesh's size.
constexpr double kBulge = 1e-9;
// Largest product of the numbers of vertices and triangles of a mesh that is tested for convexity.
// For a larger mesh, the test would cost more time than it saves.
constexpr std::size_t kMostComparisons = 1'000'000;

using Plane = Eigen::Hyperplane<double, 3>;

/// Returns the planes of a convex mesh's faces, with normals outwards, in the frame W of X_WG.
/// Returns an empty list if the mesh is not convex or too large to be tested.
std::vector<Plane> FacesOf(const model::TriangleMesh& mesh, const model::Pose& X_WG) {
  if (mesh.vertices.size() * mesh.triangles.size() > kMostComparisons) return {};
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector3d& p_G : mesh.vertices) corners.emplace_back(X_WG * p_G);
  const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
  double size = 0;
  for (const Eigen::Vector3d& p : corners) size = std::max(size, (p - corners[0]).norm());
  std::vector<Plane> faces;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3d normal = (corner(j) - corner(i)).cross(corner(k) - corner(i));
    if (!(normal.norm() > 0)) continue;
    const Plane face(normal.normalized(), corner(i));
    if (std::ranges::any_of(faces, [&](const Plane& other) { return face.isApprox(other); }))
      continue;
    const auto beyond = [&](const Eigen::Vector3d& p) {
      return face.signedDistance(p) > kBulge * size;
    };
    if (std::ranges::any_of(corners, beyond)) return {};
    faces.push_back(face);
  }
  return faces;
}

/// Point test for a part: uses precomputed planes of its faces if the part is a convex mesh.
class Region {
 public:
  explicit Region(const PlacedPart& placed) : placed_(placed) {
    const model::Shape& shape = placed.part->shape;
    if (shape.type == model::GeomType::kMesh) faces_ = FacesOf(*shape.mesh, placed.X_WG);
  }

  bool Contains(const Eigen::Vector3d& p_W) const {
    if (!placed_.box_W.contains(p_W)) return false;
    if (faces_.empty()) return model::Contains(placed_.part->shape, placed_.X_WG, p_W);
    return std::ranges::all_of(faces_,
                               [&](const Plane& face) { return face.signedDistance(p_W) <= 0; });
  }

 private:
  const PlacedPart& placed_;
  std::vector<Plane> faces_;
};

/// Estimates the overlap: counts the points of each part that are also inside earlier parts.
class OverlapCount {
 public:
  explicit OverlapCount(std::span<const PlacedPart> parts) : parts_(parts) {
    for (const PlacedPart& placed : parts) {
      regions_.emplace_back(placed);
      mass_ += placed.part->mass;
    }
  }

  Overlap Run() {
    for (std::size_t i = 1; i < parts_.size(); ++i) AddOverlapOf(i);
    return overlap_;
  }

 private:
  bool MayOverlap(std::size_t i, std::size_t j) const {
    // Pieces of one shape do not overlap: they only meet at their faces.
    const std::string& shape = parts_[i].part->piece_of;
    if (!shape.empty() && shape == parts_[j].part->piece_of) return false;
    return (parts_[i].box_W.intersection(parts_[j].box_W).sizes().array() > 0).all();
  }

  void AddOverlapOf(std::size_t i) {
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < i; ++j) {
      if (MayOverlap(i, j)) others.push_back(j);
    }
    const double part_mass = parts_[i].part->mass;
    if (others.empty() || !(part_mass > 0)) return;
    int inside = 0;
    std::vector<int> shared(others.size());
    int twice = 0;
    for (const Eigen::Vector3d& p_W : PointsAround(parts_[i])) {
      if (!regions_[i].Contains(p_W)) continue;
      ++inside;
      const auto other =
          std::ranges::find_if(others, [&](std::size_t j) { return regions_[j].Contains(p_W); });
      if (other == others.end()) continue;
      ++twice;
      ++shared[static_cast<std::size_t>(other - others.begin())];
    }
    if (inside == 0) return;
    overlap_.mass += part_mass * twice / inside;
    for (std::size_t j = 0; j < others.size(); ++j) {
      const double mass = part_mass * shared[j] / inside;
      if (mass <= most_) continue;
      most_ = mass;
      overlap_.first = others[j];
      overlap_.second = i;
    }
  }

  /// Returns points of a Sobol sequence in the bounding box of a part, which is aligned with the
  /// part's own frame.
  std::vector<Eigen::Vector3d> PointsAround(const PlacedPart& placed) const {
    const model::Box3 box = model::BoundsOf(placed.part->shape, {});
    boost::random::sobol sequence(3);
    const double mass = placed.part->mass;
    const double share = std::min(1.0, mass / (kTenth * mass_));
    const int count = std::max(kFewestPoints, static_cast<int>(std::lround(kMostPoints * share)));
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(count));
    for (Eigen::Vector3d& p : points) {
      for (double& number : p) number = std::ldexp(static_cast<double>(sequence()), -64);
      p = placed.X_WG * (box.min + p.cwiseProduct(box.max - box.min)).eval();
    }
    return points;
  }

  std::span<const PlacedPart> parts_;
  std::vector<Region> regions_;
  double mass_ = 0;  // kg, mass of all parts
  Overlap overlap_;
  double most_ = 0;  // kg, mass shared by overlap_.first and overlap_.second
};

}  // namespace

Overlap FindOverlap(std::span<const PlacedPart> parts) { return OverlapCount(parts).Run(); }

}  // namespace mjforge::static_checks
