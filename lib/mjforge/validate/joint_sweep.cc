// Moves one joint after the other through its range, then all joints to combinations of positions
// from a Sobol sequence, and collects contacts and bounds.
#include "mjforge/validate/joint_sweep.h"

#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/validate/contact_finder.h"

namespace mjforge::validate {
namespace {

// Joint id for contacts found while several joints move; sorts after all other joint ids.
constexpr int kTogether = std::numeric_limits<int>::max();
// Largest number of dimensions for which all combinations of the ends of ranges are tried.
constexpr std::size_t kMostCorners = 8;
// Smaller differences of depth are rounding errors.
constexpr double kSameDepth = 1e-9;  // m
// Largest dimension of a point of Boost's Sobol sequence.
constexpr std::size_t kMostDimensions = boost::random::default_sobol_table::max_dimension;

/// Axes about which a ball joint turns: directions to faces, edges and corners of a cube, one of
/// each opposite pair.
constexpr int kBallAxes[][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0},
                                {1, 0, 1},  {1, 0, -1}, {0, 1, 1}, {0, 1, -1}, {1, 1, 1},
                                {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};

struct MovedJoint {
  int id = 0;
  bool ball = false;
  double low = 0;  // rad or m; 0 for a ball joint
  double high = 0;
  /// Returns the number of coordinates, from 0 to 1, that determine the joint's position.
  std::size_t dimensions() const { return ball ? 3 : 1; }
};

/// Returns the joints that the sweep moves: hinges, ball joints, and slides with a range. Adds the
/// names of the other slides to `unlimited_slides`.
std::vector<MovedJoint> JointsToMove(const mjModel& m, std::vector<std::string>& unlimited_slides) {
  std::vector<MovedJoint> joints;
  for (int i = 0; i < m.njnt; ++i) {
    if (const auto range = compiled::RangeOf(m, i)) {
      joints.push_back({i, m.jnt_type[i] == mjJNT_BALL, range->low, range->high});
    } else if (m.jnt_type[i] == mjJNT_SLIDE) {
      unlimited_slides.emplace_back(m.names + m.name_jntadr[i]);
    }
  }
  return joints;
}

class Sweeper {
 public:
  Sweeper(mjModel& m, int frame)
      : m_(m), finder_(m), joints_(JointsToMove(m, sweep_.unlimited_slides)) {
    Reset();
    finder_.Move();
    X_AW_ = compiled::PoseAt(finder_.data().xpos, finder_.data().xquat, frame).Inverse();
    // If no geom collides, the bounds include visual geoms, like those in model::Bounds.
    for (int i = 0; i < m.ngeom; ++i) {
      any_collides_ |= m.geom_bodyid[i] != 0 && compiled::Collides(m, i);
    }
  }

  Sweep Run() {
    Measure(kTogether, 0);
    for (const MovedJoint& joint : joints_) {
      if (joint.ball) {
        TurnBall(joint);
      } else {
        MoveJoint(joint);
      }
      Reset();
    }
    if (joints_.size() > 1) Combine();
    Collect();
    return std::move(sweep_);
  }

 private:
  struct DeepestContact {
    BodyContact contact;
    double value = 0;
  };

  mjtNum* QposOf(const MovedJoint& joint) {
    return finder_.qpos().data() + m_.jnt_qposadr[joint.id];
  }

  void Reset() { std::ranges::copy(compiled::StartOf(m_), finder_.qpos().begin()); }

  void MoveJoint(const MovedJoint& joint) {
    for (int i = 0; i < Sweep::kSteps; ++i) {
      const double share = static_cast<double>(i) / (Sweep::kSteps - 1);
      const double value = std::lerp(joint.low, joint.high, share);
      *QposOf(joint) = value;
      Measure(joint.id, value);
    }
  }

  void TurnBall(const MovedJoint& joint) {
    for (const auto& [x, y, z] : kBallAxes) {
      for (int i = 0; i < Sweep::kSteps; ++i) {
        const double angle = joint.high * (2.0 * i / (Sweep::kSteps - 1) - 1);
        SetBall(joint, Eigen::Vector3d(x, y, z).normalized(), angle);
        Measure(joint.id, std::abs(angle));
      }
    }
  }

  void SetBall(const MovedJoint& joint, const Eigen::Vector3d& axis, double angle) {
    std::ranges::copy(compiled::BallAt(m_, joint.id, axis, angle), QposOf(joint));
  }

  /// Moves all joints to the position of a point in the unit cube.
  void SetAll(std::span<const double> point) {
    std::size_t at = 0;
    const auto next = [&] { return point[at++ % point.size()]; };
    for (const MovedJoint& joint : joints_) {
      if (!joint.ball) {
        *QposOf(joint) = std::lerp(joint.low, joint.high, next());
        continue;
      }
      const double z = 2 * next() - 1;
      const double around = 2 * std::numbers::pi * next();
      const double across = std::sqrt(std::max(1 - z * z, 0.0));
      SetBall(joint, {across * std::cos(around), across * std::sin(around), z},
              joint.high * next());
    }
  }

  void Combine() {
    std::size_t dimensions = 0;
    for (const MovedJoint& joint : joints_) dimensions += joint.dimensions();
    std::vector<double> point(std::min(dimensions, kMostDimensions));
    boost::random::sobol sequence(point.size());
    for (int i = 0; i < Sweep::kCombinations; ++i) {
      // Stretches the sequence, whose points keep the distance kEdge from 0 and 1, so that some
      // points reach 0 and 1.
      constexpr double kEdge = 0.5 / Sweep::kCombinations;
      for (double& number : point) {
        const double share = std::ldexp(static_cast<double>(sequence()), -64);
        number = std::clamp((share - kEdge) / (1 - 2 * kEdge), 0.0, 1.0);
      }
      SetAll(point);
      Measure(kTogether, 0);
    }
    if (point.size() > kMostCorners) return;
    for (std::size_t corner = 0; corner < std::size_t{1} << point.size(); ++corner) {
      for (std::size_t i = 0; i < point.size(); ++i) point[i] = corner >> i & 1 ? 1 : 0;
      SetAll(point);
      Measure(kTogether, 0);
    }
  }

  /// Adds the boxes of geoms and the contacts at the present joint positions to the results.
  /// `joint` is the only joint that moves, and `value` its position; kTogether if several joints
  /// move.
  void Measure(int joint, double value) {
    finder_.Move();
    const int first = joint == kTogether ? 1 : m_.jnt_bodyid[joint];
    const int end = joint == kTogether ? m_.nbody : compiled::SubtreeEnd(m_, first);
    const auto moves = [&](int body) { return body >= first && body < end; };
    for (int body = first; body < end; ++body) AddBoxOf(body);
    for (const BodyContact& contact : finder_.Find()) {
      // Skips pairs whose relative pose this joint does not change.
      if (joint != kTogether && moves(contact.body1) == moves(contact.body2)) {
        continue;
      }
      if (contact.distance > 0) continue;  // within a margin, without penetration
      const auto [found, is_new] = deepest_.try_emplace({joint, contact.body1, contact.body2},
                                                        DeepestContact{contact, value});
      if (is_new || contact.distance >= found->second.contact.distance - kSameDepth) continue;
      found->second = {contact, value};
    }
  }

  void AddBoxOf(int body) {
    const mjData& data = finder_.data();
    for (int i = 0; i < m_.body_geomnum[body]; ++i) {
      const int geom = m_.body_geomadr[body] + i;
      if (any_collides_ && !compiled::Collides(m_, geom)) continue;
      const model::Pose X_WG = compiled::GeomPose(data, geom);
      sweep_.aabb.Add(compiled::GeomBox(m_, geom, X_AW_ * X_WG));
    }
  }

  /// Adds the deepest contact of each combination of a joint and a pair of bodies to the result of
  /// the sweep. Leaves out a contact found while all joints move if one joint alone makes the same
  /// bodies touch.
  void Collect() {
    std::set<std::pair<int, int>> reported;
    for (const auto& [key, deepest] : deepest_) {
      const auto [joint, body1, body2] = key;
      const bool is_new = reported.emplace(body1, body2).second;
      if (is_new || joint != kTogether) sweep_.contacts.push_back(ContactOf(joint, deepest));
    }
  }

  Sweep::Contact ContactOf(int joint, const DeepestContact& deepest) const {
    const BodyContact& contact = deepest.contact;
    const auto name = [&](const int* names, int id) { return std::string(m_.names + names[id]); };
    return {joint == kTogether ? std::string() : name(m_.name_jntadr, joint),
            deepest.value,
            name(m_.name_bodyadr, contact.body1),
            name(m_.name_geomadr, contact.geom1),
            name(m_.name_bodyadr, contact.body2),
            name(m_.name_geomadr, contact.geom2),
            std::max(-contact.distance, 0.0)};
  }

  mjModel& m_;
  Sweep sweep_;
  ContactFinder finder_;
  std::vector<MovedJoint> joints_;
  model::Pose X_AW_;
  bool any_collides_ = false;
  std::map<std::tuple<int, int, int>, DeepestContact> deepest_;  // by joint and pair of bodies
};

}  // namespace

Sweep SweepModel(mjModel& m, int frame) { return Sweeper(m, frame).Run(); }

}  // namespace mjforge::validate
