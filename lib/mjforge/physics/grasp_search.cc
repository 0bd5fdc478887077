// Search for grasps: casts rays from both sides of a point to find opposite faces, and prefers
// faces of low cost.
#include "mjforge/physics/grasp_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <boost/random/sobol.hpp>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/solid_geoms.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using Eigen::Vector3d;

constexpr double kMargin = 0.005;  // m, gap between each jaw and its face before the jaws close
// Distance from a ray to the rays that measure the face's slope.
constexpr double kAside = 0.0003;   // m
constexpr double kFriction = 1;     // tangent of the half-angle of the jaws' friction cones
constexpr double kSeam = 2e-5;      // m, offset of rays, to miss the seams between pieces
constexpr double kThinnest = 5e-4;  // m, least distance between the two faces
constexpr double kOffset = 0.008;   // m, distance from a site to the points beside it
constexpr double kPerOffset = 20;   // cost per metre of distance from a site; a slope of 1 costs 1
constexpr int kApproaches = 8;  // number of directions of the fingers about a line between faces
constexpr int kPoints = 48;     // number of points tried in the box of an object without sites

/// Returns 13 unit vectors: the directions from a cell of a cubic grid to its 26 neighbours,
/// without their opposites.
std::vector<Vector3d> Directions() {
  std::vector<Vector3d> directions;
  directions.reserve(13);
  for (int nonzero = 1; nonzero <= 3; ++nonzero) {
    for (int i = 14; i < 27; ++i) {
      const Eigen::Vector3i direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (direction.squaredNorm() == nonzero)
        directions.emplace_back(direction.cast<double>().normalized());
    }
  }
  return directions;
}

/// Returns two unit vectors that are perpendicular to the unit vector `way` and to each other.
std::pair<Vector3d, Vector3d> Across(const Vector3d& way) {
  const Vector3d one = way.unitOrthogonal();
  return {one, way.cross(one)};
}

}  // namespace

/// Line between two opposite faces, in the world's frame.
struct GraspSearch::FaceLine {
  Vector3d middle = Vector3d::Zero();  // m, midpoint between the faces
  Vector3d way = Vector3d::UnitY();    // direction from the second face to the first
  double width = 0;                    // m
  double cost = 0;                     // grasps of low cost are tried first
  int body = 0;                        // id of the body with the first face
};

double OpeningFor(const GraspCandidate& candidate, const model::GraspingCheck& grasping) {
  return std::min(candidate.width + 2 * kMargin, grasping.width);
}

GraspSearch::GraspSearch(const mjModel& m, mjData& d, const Gripper& gripper,
                         std::span<const mjtNum> start, const model::GraspingCheck& grasping)
    : m_(m), d_(d), gripper_(gripper), start_(start), grasping_(grasping) {
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (IsSolid(m, geom) && !gripper.Has(geom)) geoms_.push_back(geom);
  }
  gripper.Place(d, start, {}, 0);
  compiled::UpdatePoses(m, d);
}

std::vector<GraspCandidate> GraspSearch::AtSite(const model::Pose& X_WS, int body) const {
  const Vector3d p_W = X_WS.p;
  const Eigen::Quaterniond q = X_WS.q;
  std::vector<FaceLine> lines = LinesThrough(p_W, q, body);
  for (int side = 0; side < 6; ++side) {
    const Vector3d offset = q * ((side % 2 == 0 ? kOffset : -kOffset) * Vector3d::Unit(side / 2));
    for (FaceLine line : LinesThrough(p_W + offset, q, body)) {
      line.cost += kPerOffset * kOffset;
      lines.push_back(line);
    }
  }
  return Best(std::move(lines));
}

std::vector<GraspCandidate> GraspSearch::Anywhere(int root) const {
  const model::Box3 box = compiled::CollidingBox(m_, d_, root);
  if (box.empty()) return {};
  const Vector3d sides = box.max - box.min;
  const Vector3d center = VectorAt(d_.subtree_com, root);
  boost::random::sobol sequence(3);
  std::vector<FaceLine> lines;
  for (int i = 0; i < kPoints; ++i) {
    Vector3d share;
    for (double& number : share)
      number = static_cast<double>(sequence()) / static_cast<double>(sequence.max());
    const Vector3d p_W = box.min + sides.cwiseProduct(share);
    for (FaceLine line : LinesThrough(p_W, Eigen::Quaterniond::Identity(), root)) {
      line.cost += (line.middle - center).norm() / sides.norm();
      lines.push_back(line);
    }
  }
  return Best(std::move(lines));
}

/// Returns the distance to the nearest geom of the object along a ray, m, and sets `hit` to the id
/// of that geom. Returns infinity if the ray hits nothing.
double GraspSearch::Distance(const Vector3d& from, const Vector3d& way, int& hit) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int geom : geoms_) {
    const double radius = m_.geom_rbound[geom];
    const Vector3d to = VectorAt(d_.geom_xpos, geom) - from;
    if ((to - to.dot(way) * way).squaredNorm() > radius * radius) continue;
    const double distance = RayTo(m_, d_, geom, from, way);
    if (distance < 0 || distance >= nearest) continue;
    nearest = distance;
    hit = geom;
  }
  return nearest;
}

/// Returns true if `owner` is the root of a tree and the geom belongs to this tree, or if `owner`
/// is another body and the geom belongs to `owner` or to a body welded to it.
bool GraspSearch::IsPartOf(int geom, int owner) const {
  const int body = m_.geom_bodyid[geom];
  const bool is_root = m_.body_rootid[owner] == owner;
  return is_root ? m_.body_rootid[body] == owner : m_.body_weldid[body] == m_.body_weldid[owner];
}

/// Returns the lines through the point `p_W`, in 13 directions of the frame `q_WS`, between two
/// opposite faces of `owner` (IsPartOf). Each line is inside the friction cones of both faces.
std::vector<GraspSearch::FaceLine> GraspSearch::LinesThrough(const Vector3d& p_W,
                                                             const Eigen::Quaterniond& q_WS,
                                                             int owner) const {
  std::vector<FaceLine> lines;
  for (const Vector3d& direction : Directions()) {
    const Vector3d way = q_WS * direction;
    const auto [one, two] = Across(way);
    const Vector3d start = p_W + kSeam * (one + two / 2);
    FaceLine line{.way = way};
    double ends[2] = {0, 0};  // distances of the faces from the point, m
    bool is_grasp = true;
    for (int side = 0; side < 2 && is_grasp; ++side) {
      const Vector3d inwards = side == 0 ? Vector3d(-way) : way;
      const Vector3d from = start - grasping_.width / 2 * inwards;
      int hit = 0;
      const double distance = Distance(from, inwards, hit);
      is_grasp = distance < grasping_.width && IsPartOf(hit, owner);
      if (!is_grasp) break;
      int beside = 0;
      const Eigen::Vector2d slope(Distance(from + kAside * one, inwards, beside) - distance,
                                  Distance(from + kAside * two, inwards, beside) - distance);
      line.cost = std::max(line.cost, slope.norm() / kAside);
      is_grasp = line.cost <= kFriction;
      ends[side] = grasping_.width / 2 - distance;
      if (side == 0) line.body = m_.geom_bodyid[hit];
    }
    line.width = ends[0] + ends[1];
    if (!is_grasp || line.width < kThinnest || line.width + kMargin > grasping_.width) continue;
    line.middle = p_W + (ends[0] - ends[1]) / 2 * way;
    lines.push_back(line);
  }
  return lines;
}

/// Returns true if the open gripper, placed for this grasp, touches nothing.
bool GraspSearch::IsFree(const GraspCandidate& candidate) const {
  gripper_.Place(d_, start_, candidate.X_WJ, OpeningFor(candidate, grasping_));
  mj_kinematics(&m_, &d_);
  mj_collision(&m_, &d_);
  return !gripper_.Touches(d_);
}

/// Returns the grasps of lowest cost, at most grasping.tries. The lines of any two grasps differ by
/// more than 20 deg, or have midpoints at least 2 kOffset apart. For each line, takes the first
/// direction of the fingers in which the open gripper touches nothing.
std::vector<GraspCandidate> GraspSearch::Best(std::vector<FaceLine> lines) const {
  std::ranges::stable_sort(lines, {}, &FaceLine::cost);
  std::vector<GraspCandidate> best;
  std::vector<FaceLine> taken;
  for (const FaceLine& line : lines) {
    if (std::ssize(best) == grasping_.tries) break;
    const bool is_known = std::ranges::any_of(taken, [&](const FaceLine& other) {
      return std::abs(line.way.dot(other.way)) > std::cos(std::numbers::pi / 9) &&
             (line.middle - other.middle).norm() < 2 * kOffset;
    });
    if (is_known) continue;
    const auto [one, two] = Across(line.way);
    for (int i = 0; i < kApproaches; ++i) {
      const double angle = 2 * std::numbers::pi * i / kApproaches;
      const Vector3d approach = std::cos(angle) * one + std::sin(angle) * two;
      const model::Pose X_WJ = {line.middle, model::FromXyAxes(line.way.cross(approach), line.way)};
      const GraspCandidate candidate = {X_WJ, line.width, line.body};
      if (!IsFree(candidate)) continue;
      best.push_back(candidate);
      taken.push_back(line);
      break;
    }
  }
  return best;
}

}  // namespace mjforge::physics
