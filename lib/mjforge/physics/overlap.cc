#include "mjforge/physics/overlap.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

#include "mjforge/physics/solids.h"

namespace mjforge::physics {
namespace {

// Points in the box of a solid that is a tenth of the whole or more; fewer in smaller ones, whose
// errors count less.
constexpr int kMostPoints = 2000;
constexpr int kFewestPoints = 100;
constexpr double kTenth = 0.1;
// Corners of a convex mesh may be beyond its faces by rounding, as a share of its size.
constexpr double kBulge = 1e-9;
// Looking whether a mesh is convex must not cost more than asking its triangles would.
constexpr std::size_t kMostComparisons = 1'000'000;

bool Meet(const model::Box3& a, const model::Box3& b) {
  return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

using Plane = Eigen::Hyperplane<double, 3>;

/// The planes of a convex mesh's faces, normals outwards; none if it is not convex.
std::vector<Plane> FacesOf(const model::TriangleMesh& mesh, const model::Pose& X_BG) {
  if (mesh.vertices.size() * mesh.triangles.size() > kMostComparisons) return {};
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector3d& p_G : mesh.vertices) corners.emplace_back(X_BG.p + X_BG.q * p_G);
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

/// A solid of a body that is asked about many points in the body's frame.
class Region {
 public:
  explicit Region(const model::Part& part)
      : part_(&part), box_(model::BoundsOf(part.shape, part.X_BG)) {
    if (part.shape.type == model::GeomType::kMesh) faces_ = FacesOf(*part.shape.mesh, part.X_BG);
  }

  const model::Box3& box() const { return box_; }

  bool Contains(const Eigen::Vector3d& p_B) const {
    if ((p_B.array() < box_.min.array()).any() ||
        (p_B.array() > box_.max.array()).any()) {
      return false;
    }
    if (faces_.empty()) return model::Contains(part_->shape, part_->X_BG, p_B);
    return std::ranges::all_of(faces_,
                               [&](const Plane& face) { return face.signedDistance(p_B) <= 0; });
  }

 private:
  const model::Part* part_;
  model::Box3 box_;
  std::vector<Plane> faces_;
};

/// How much of each solid is in earlier ones.
class Count {
 public:
  explicit Count(const std::vector<model::Part>& parts) : parts_(parts) {
    for (const model::Part& part : parts) {
      regions_.emplace_back(part);
      mass_ += part.mass;
    }
  }

  Overlap Run() {
    for (std::size_t i = 1; i < parts_.size(); ++i) Look(i);
    return overlap_;
  }

 private:
  void Look(std::size_t i) {
    const model::Part& solid = parts_[i];
    std::vector<std::size_t> others;
    for (std::size_t j = 0; j < i; ++j) {
      // Pieces of one shape meet at their faces.
      const bool are_one = !solid.piece_of.empty() && solid.piece_of == parts_[j].piece_of;
      if (!are_one && Meet(regions_[i].box(), regions_[j].box())) others.push_back(j);
    }
    if (others.empty() || !(solid.mass > 0)) return;
    int inside = 0;
    std::vector<int> shared(others.size());
    int twice = 0;
    for (const Eigen::Vector3d& p_B : PointsAround(solid)) {
      if (!regions_[i].Contains(p_B)) continue;
      ++inside;
      const auto other =
          std::ranges::find_if(others, [&](std::size_t j) { return regions_[j].Contains(p_B); });
      if (other == others.end()) continue;
      ++twice;
      ++shared[static_cast<std::size_t>(other - others.begin())];
    }
    if (inside == 0) return;
    overlap_.mass += solid.mass * twice / inside;
    for (std::size_t j = 0; j < others.size(); ++j) {
      const double mass = solid.mass * shared[j] / inside;
      if (mass <= most_) continue;
      most_ = mass;
      overlap_.first = others[j];
      overlap_.second = i;
    }
  }

  /// Points in the box of a solid in its own frame, from a sequence that fills it evenly.
  std::vector<Eigen::Vector3d> PointsAround(const model::Part& solid) const {
    const model::Box3 box = model::BoundsOf(solid.shape, {});
    boost::random::sobol sequence(3);
    const double mass = solid.mass;
    const double share = std::min(1.0, mass / (kTenth * mass_));
    const int count = std::max(kFewestPoints, static_cast<int>(std::lround(kMostPoints * share)));
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(count));
    for (Eigen::Vector3d& p : points) {
      for (double& number : p) number = std::ldexp(static_cast<double>(sequence()), -64);
      p = solid.X_BG.p + solid.X_BG.q * (box.min + p.cwiseProduct(box.max - box.min)).eval();
    }
    return points;
  }

  const std::vector<model::Part>& parts_;
  std::vector<Region> regions_;
  double mass_ = 0;
  Overlap overlap_;
  double most_ = 0;
};

}  // namespace

Overlap FindOverlap(const std::vector<model::Part>& parts) { return Count(parts).Run(); }

}  // namespace mjforge::physics
