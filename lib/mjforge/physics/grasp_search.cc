#include "mjforge/physics/grasp_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <boost/random/sobol.hpp>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using Eigen::Vector3d;

constexpr double kRoom = 0.005;     // m, on either side of what they close on
constexpr double kAside = 0.0003;   // m, from a ray to those that tell how its face lies
constexpr double kFriction = 1;     // of the jaws: the tangent of the friction cone
constexpr double kSeam = 2e-5;      // m, from a point to its rays: pieces may meet at it
constexpr double kThinnest = 5e-4;  // m
constexpr double kOffset = 0.008;   // m, beside a site
constexpr double kPerOffset = 20;   // 1/m: what a metre beside a site costs, as slopes do
constexpr int kApproaches = 8;
constexpr int kPoints = 48;  // in the box of an object that has no sites

/// Each of the 26 neighbours of a cube, and not its opposite.
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

/// Two directions across.
std::pair<Vector3d, Vector3d> Across(const Vector3d& way) {
  const Vector3d one = way.unitOrthogonal();
  return {one, way.cross(one)};
}

model::Pose Frame(const Vector3d& p_W, const Vector3d& y, const Vector3d& z) {
  return {p_W, model::FromXyAxes(y.cross(z), y)};
}

}  // namespace

/// Between two faces.
struct GraspSearch::Line {
  Vector3d middle = Vector3d::Zero();
  Vector3d way = Vector3d::UnitY();
  double width = 0;
  double cost = 0;
  int body = 0;
};

double OpeningFor(const Candidate& candidate, const model::Grasping& grasping) {
  return std::min(candidate.width + 2 * kRoom, grasping.width);
}

GraspSearch::GraspSearch(const mjModel& m, mjData& d, const Jaws& jaws,
                         std::span<const mjtNum> start, const model::Grasping& grasping)
    : m_(m), d_(d), jaws_(jaws), start_(start), grasping_(grasping) {
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const bool is_solid = compiled::GeomTypeOf(m.geom_type[geom]).has_value();
    if (is_solid && compiled::Collides(m, geom) && !jaws.Has(geom)) geoms_.push_back(geom);
  }
  jaws.Place(d, start, {}, 0);
  mj_kinematics(&m, &d);
  mj_comPos(&m, &d);
}

std::vector<Candidate> GraspSearch::At(const model::Pose& X_WS, int only) const {
  const Vector3d p_W = X_WS.p;
  const Eigen::Quaterniond q = X_WS.q;
  std::vector<Line> lines = LinesThrough(p_W, q, only);
  for (int side = 0; side < 6; ++side) {
    const Vector3d offset = q * ((side % 2 == 0 ? kOffset : -kOffset) * Vector3d::Unit(side / 2));
    for (Line line : LinesThrough(p_W + offset, q, only)) {
      line.cost += kPerOffset * kOffset;
      lines.push_back(line);
    }
  }
  return Best(std::move(lines));
}

std::vector<Candidate> GraspSearch::On(int root) const {
  const model::Box3 box = compiled::CollidingBox(m_, d_, root);
  if (box.empty()) return {};
  const Vector3d sides = box.max - box.min;
  const Vector3d center = VectorAt(d_.subtree_com, root);
  boost::random::sobol sequence(3);
  std::vector<Line> lines;
  for (int i = 0; i < kPoints; ++i) {
    Vector3d share;
    for (double& number : share)
      number = static_cast<double>(sequence()) / static_cast<double>(sequence.max());
    const Vector3d p_W = box.min + sides.cwiseProduct(share);
    for (Line line : LinesThrough(p_W, Eigen::Quaterniond::Identity(), root)) {
      line.cost += (line.middle - center).norm() / sides.norm();
      lines.push_back(line);
    }
  }
  return Best(std::move(lines));
}

double GraspSearch::Distance(const Vector3d& from, const Vector3d& way, int& hit) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int geom : geoms_) {
    const double radius = m_.geom_rbound[geom];
    const Vector3d to = VectorAt(d_.geom_xpos, geom) - from;
    if ((to - to.dot(way) * way).squaredNorm() > radius * radius) continue;
    const mjtNum distance =
        m_.geom_type[geom] == mjGEOM_MESH
            ? engine::RayMesh(&m_, &d_, geom, from.data(), way.data())
            : engine::RayGeom(d_.geom_xpos + 3 * geom, d_.geom_xmat + 9 * geom,
                              m_.geom_size + 3 * geom, from.data(), way.data(), m_.geom_type[geom]);
    if (distance < 0 || distance >= nearest) continue;
    nearest = distance;
    hit = geom;
  }
  return nearest;
}

bool GraspSearch::IsPartOf(int geom, int only) const {
  const int body = m_.geom_bodyid[geom];
  const bool is_root = m_.body_rootid[only] == only;
  return is_root ? m_.body_rootid[body] == only : m_.body_weldid[body] == m_.body_weldid[only];
}

std::vector<GraspSearch::Line> GraspSearch::LinesThrough(const Vector3d& p_W,
                                                         const Eigen::Quaterniond& q_WS,
                                                         int only) const {
  std::vector<Line> lines;
  for (const Vector3d& direction : Directions()) {
    const Vector3d way = q_WS * direction;
    const auto [one, two] = Across(way);
    const Vector3d start = p_W + kSeam * (one + two / 2);
    Line line{.way = way};
    double ends[2] = {0, 0};  // along the way from the point
    bool fits = true;
    for (int side = 0; side < 2 && fits; ++side) {
      const Vector3d inwards = side == 0 ? Vector3d(-way) : way;
      const Vector3d from = start - grasping_.width / 2 * inwards;
      int hit = 0;
      const double distance = Distance(from, inwards, hit);
      fits = distance < grasping_.width && IsPartOf(hit, only);
      if (!fits) break;
      int beside = 0;
      const Eigen::Vector2d slope(Distance(from + kAside * one, inwards, beside) - distance,
                                  Distance(from + kAside * two, inwards, beside) - distance);
      line.cost = std::max(line.cost, slope.norm() / kAside);
      fits = line.cost <= kFriction;
      ends[side] = grasping_.width / 2 - distance;
      if (side == 0) line.body = m_.geom_bodyid[hit];
    }
    line.width = ends[0] + ends[1];
    if (!fits || line.width < kThinnest || line.width + kRoom > grasping_.width) continue;
    line.middle = p_W + (ends[0] - ends[1]) / 2 * way;
    lines.push_back(line);
  }
  return lines;
}

bool GraspSearch::IsFree(const Candidate& candidate) const {
  jaws_.Place(d_, start_, candidate.X_WJ, OpeningFor(candidate, grasping_));
  mj_kinematics(&m_, &d_);
  mj_collision(&m_, &d_);
  return !jaws_.Touch(d_);
}

std::vector<Candidate> GraspSearch::Best(std::vector<Line> lines) const {
  std::ranges::stable_sort(lines, {}, &Line::cost);
  std::vector<Candidate> best;
  std::vector<Line> taken;
  for (const Line& line : lines) {
    if (std::ssize(best) == grasping_.tries) break;
    const bool is_known = std::ranges::any_of(taken, [&](const Line& other) {
      return std::abs(line.way.dot(other.way)) > std::cos(std::numbers::pi / 9) &&
             (line.middle - other.middle).norm() < 2 * kOffset;
    });
    if (is_known) continue;
    const auto [one, two] = Across(line.way);
    for (int i = 0; i < kApproaches; ++i) {
      const double angle = 2 * std::numbers::pi * i / kApproaches;
      const Vector3d approach = std::cos(angle) * one + std::sin(angle) * two;
      const Candidate candidate = {Frame(line.middle, line.way, approach), line.width, line.body};
      if (!IsFree(candidate)) continue;
      best.push_back(candidate);
      taken.push_back(line);
      break;
    }
  }
  return best;
}

}  // namespace mjforge::physics
