#include "mjforge/physics/drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

constexpr std::size_t Index(int i) { return static_cast<std::size_t>(i); }

constexpr double kMoveTime = 0.5;   // s, from one end to the other
constexpr double kHoldTime = 0.1;   // s, at an end, once it is there or no longer comes nearer
constexpr double kMostWaiting = 1;  // s, for what follows slowly
constexpr double kThere = 0.01;     // of the range
// How fast errors are to vanish, rad/s: slow beside the 50 rad/s of MuJoCo's own
// limits and contacts, fast beside a move.
constexpr double kStiffness = 20;
// Targets lie so much of the range beyond its ends, so that the limits have to hold.
constexpr double kPush = 0.1;
// MuJoCo's limit of a ball knows one inertia for all axes, and is soft about a thin body's own.
constexpr double kPushOfBall = 0.02;
// An error counts up to kPush of the range, so that what is stuck is not crushed; of a joint
// that is held, up to this.
constexpr double kMostHeld = 0.1;  // rad or m
// A free body becomes so much heavier that a joint's forces do not move it.
constexpr double kHeld = 1e6;

/// From 0 to 1 without a jolt, and how fast (1/s) and by what acceleration (1/s^2).
struct Move {
  double at = 0;
  double speed = 0;
  double acceleration = 0;
};
Move MoveAt(double time) {
  const double share = std::clamp(time / kMoveTime, 0.0, 1.0);
  if (share >= 1) return {1, 0, 0};
  const double phase = std::numbers::pi * share;
  const double rate = std::numbers::pi / kMoveTime;
  return {(1 - std::cos(phase)) / 2, rate * std::sin(phase) / 2, rate * rate * std::cos(phase) / 2};
}

/// One joint moved along one of its axes. Positions are counted from the joint's
/// place in the model's own pose.
struct Path {
  int joint = 0;
  int axis = 0;  // 1, 2 of a ball
  bool limited = false;
  double low = 0;
  double high = 0;
  double start = 0;  // a ball is driven from the model's own pose
};

/// Equality of two joints: y = poly(x), both counted from the model's own pose.
struct Coupling {
  int y = 0;
  int x = 0;
  const mjtNum* poly = nullptr;

  bool IsLinear() const { return poly[1] != 0 && poly[2] == 0 && poly[3] == 0 && poly[4] == 0; }
  double At(double value) const {
    return poly[0] + value * (poly[1] + value * (poly[2] + value * (poly[3] + value * poly[4])));
  }
  double SlopeAt(double value) const {
    return poly[1] + value * (2 * poly[2] + value * (3 * poly[3] + value * 4 * poly[4]));
  }
};

std::vector<Path> PathsOf(const mjModel& m, int joint) {
  const std::optional<compiled::JointRange> range = compiled::RangeOf(m, joint);
  if (!range) return {};
  if (m.jnt_type[joint] != mjJNT_BALL) {
    const int at = m.jnt_qposadr[joint];
    const double zero = m.qpos0[at];
    const double start = compiled::StartOf(m)[Index(at)] - zero;
    return {{joint, 0, range->limited, range->low - zero, range->high - zero, start}};
  }
  const bool limited = range->limited;
  const double most = limited ? range->high : 0.9 * range->high;  // half a turn has no way
  return {{joint, 0, limited, -most, most},
          {joint, 1, limited, -most, most},
          {joint, 2, limited, -most, most}};
}

class Driver {
 public:
  Driver(const mjModel& m, mjData& d)
      : m_(m), d_(d), start_(compiled::StartOf(m)), coupled_(Index(m.njnt)), inertia_(Index(m.nv)) {
    for (int i = 0; i < m.neq; ++i) {
      if (m.eq_type[i] != mjEQ_JOINT) {
        // A weld, a loop: anything may have to move along.
        std::fill(coupled_.begin(), coupled_.end(), true);
        break;
      }
      Couple(m.eq_obj1id[i]);
      Couple(m.eq_obj2id[i]);
      if (m.eq_obj2id[i] >= 0 && m.eq_active[i] != 0)
        couplings_.push_back({m.eq_obj1id[i], m.eq_obj2id[i], m.eq_data + mjNEQDATA * i});
    }
    for (int i = 0; i < m.nwrap; ++i) {
      if (m.wrap_type[i] == mjWRAP_JOINT) Couple(m.wrap_objid[i]);
      if (m.wrap_type[i] == mjWRAP_SITE) std::fill(coupled_.begin(), coupled_.end(), true);
    }
  }

  Driven Run(int joint) {
    Driven driven;
    driven.joint = joint;
    driven.measured.name = compiled::NameOf(m_, mjOBJ_JOINT, joint);
    for (const Path& path : PathsOf(m_, joint)) Follow(path, driven);
    return driven;
  }

 private:
  void Couple(int joint) {
    if (joint >= 0) coupled_[Index(joint)] = true;
  }

  void Follow(const Path& path, Driven& driven) {
    mj_resetData(&m_, &d_);
    std::ranges::copy(start_, d_.qpos);
    const bool ball = m_.jnt_type[path.joint] == mjJNT_BALL;
    if (ball) {
      const int at = m_.jnt_qposadr[path.joint];
      std::copy_n(m_.qpos0 + at, 4, d_.qpos + at);
    }
    mj_forward(&m_, &d_);
    for (int i = 0; i < m_.nv; ++i) inertia_[Index(i)] = d_.qM[m_.dof_Madr[i]];
    const int dof = m_.jnt_dofadr[path.joint] + path.axis;
    inertia_[Index(dof)] = InertiaOf(dof);
    const double range = path.high - path.low;
    driven.range = std::max(driven.range, range);
    const double push = path.limited ? (ball ? kPushOfBall : kPush) * range : 0;
    driven.outside = std::max({0.0, path.low - path.start, path.start - path.high});
    // A joint that starts outside its range is pushed in by its limits first.
    const double home = std::clamp(path.start, path.low, path.high);
    lowest_ = highest_ = home;
    looks_ = driven.outside == 0;
    Go(path, path.start, path.low - push, driven);
    looks_ = true;
    Go(path, path.low - push, path.high + push, driven);
    Go(path, path.high + push, home, driven);
    const double reached = std::min(highest_, path.high) - std::max(lowest_, path.low);
    Result::Joint& measured = driven.measured;
    if (range > 0) measured.reach = std::min(measured.reach, std::max(reached, 0.0) / range);
    if (path.limited) {
      measured.overshoot = std::max({measured.overshoot, path.low - lowest_, highest_ - path.high});
    }
    measured.return_error = std::max(measured.return_error, std::abs(Value(path) - home));
  }

  void Go(const Path& path, double from, double to, Driven& driven) {
    const double dt = m_.opt.timestep;
    const double range = path.high - path.low;
    const double end = std::clamp(to, path.low, path.high);
    double nearest = std::abs(Value(path) - end);
    double held = 0;  // s, since it last came nearer
    for (double time = 0;
         held < kHoldTime && time < kMoveTime + kHoldTime + kMostWaiting && !driven.blown_up;
         time += dt) {
      const Move move = MoveAt(time);
      const double way = to - from;
      SetForces(path, {from + way * move.at, way * move.speed, way * move.acceleration});
      mj_step(&m_, &d_);
      Look(path, driven);
      const double distance = std::abs(Value(path) - end);
      const bool nears = distance > kThere * range && distance < nearest - kThere * range * dt;
      nearest = std::min(nearest, distance);
      held = time < kMoveTime || nears ? 0 : held + dt;
    }
  }

  /// What a force on a degree of freedom has to move: with all other joints held, or with
  /// what equalities and tendons make move along, as a screw's turning with its lift. A
  /// test force tells.
  double InertiaOf(int dof) {
    const double held = d_.qM[m_.dof_Madr[dof]];
    const double force = held;  // for an acceleration of about 1
    mj_forward(&m_, &d_);
    const double idle = d_.qacc[dof];
    double gained = 0;
    for (const double sign : {-1.0, 1.0}) {  // a limit may stand in one way
      d_.qfrc_applied[dof] = sign * force;
      mj_forward(&m_, &d_);
      gained = std::max(gained, sign * (d_.qacc[dof] - idle));
    }
    d_.qfrc_applied[dof] = 0;
    return gained > 0 ? std::max(held, force / gained) : held;
  }

  void SetForces(const Path& path, const Move& target) {
    std::fill_n(d_.qfrc_applied, m_.nv, 0.0);
    for (int joint = 0; joint < m_.njnt; ++joint) {
      if (m_.jnt_type[joint] == mjJNT_FREE) continue;
      const bool moved = joint == path.joint;
      const std::optional<Move> own = moved ? target
                                      : coupled_[Index(joint)]
                                          ? FollowerMove(path.joint, joint, target)
                                          : Move{StartOf(joint), 0, 0};
      if (!own) continue;
      const std::array<double, 3> errors =
          moved ? Errors(joint, path.axis, own->at) : ErrorsOfHeld(joint, own->at);
      const int dofs = m_.jnt_type[joint] == mjJNT_BALL ? 3 : 1;
      const double most = moved ? kPush * (path.high - path.low) : kMostHeld;
      for (int i = 0; i < dofs; ++i) {
        const bool along = i == (moved ? path.axis : 0);
        const int dof = m_.jnt_dofadr[joint] + i;
        const double error = std::clamp(errors[Index(i)], -most, most);
        d_.qfrc_applied[dof] =
            Force(dof, error, along ? own->speed : 0, along ? own->acceleration : 0);
      }
    }
  }

  /// Where an equality has a joint go with the one that is driven; nothing if it leaves that open.
  std::optional<Move> FollowerMove(int driven, int joint, const Move& target) const {
    for (const Coupling& coupling : couplings_) {
      if (coupling.x == driven && coupling.y == joint) {
        const double slope = coupling.SlopeAt(target.at);
        return Move{coupling.At(target.at), slope * target.speed, slope * target.acceleration};
      }
      if (coupling.y == driven && coupling.x == joint && coupling.IsLinear()) {
        const double slope = 1 / coupling.poly[1];
        return Move{slope * (target.at - coupling.poly[0]), slope * target.speed,
                    slope * target.acceleration};
      }
    }
    return std::nullopt;
  }

  /// Distance to go, of the one or three degrees of freedom of a joint.
  std::array<double, 3> Errors(int joint, int axis, double target) const {
    const int at = m_.jnt_qposadr[joint];
    if (m_.jnt_type[joint] != mjJNT_BALL) return {m_.qpos0[at] + target - d_.qpos[at], 0, 0};
    const std::array<mjtNum, 4> wanted =
        compiled::BallAt(m_, joint, Eigen::Vector3d::Unit(axis), target);
    std::array<double, 3> errors = {};
    mju_subQuat(errors.data(), wanted.data(), d_.qpos + at);
    return errors;
  }

  std::array<double, 3> ErrorsOfHeld(int joint, double target) const {
    if (m_.jnt_type[joint] != mjJNT_BALL) return Errors(joint, 0, target);
    const int at = m_.jnt_qposadr[joint];
    std::array<double, 3> errors = {};
    mju_subQuat(errors.data(), &start_[Index(at)], d_.qpos + at);
    return errors;
  }

  /// Of a joint that is not a ball, from the model's own pose.
  double StartOf(int joint) const {
    const int at = m_.jnt_qposadr[joint];
    return start_[Index(at)] - m_.qpos0[at];
  }

  double Force(int dof, double error, double speed, double acceleration) const {
    // Critically damped.
    const double wanted =
        acceleration + 2 * kStiffness * (speed - d_.qvel[dof]) + kStiffness * kStiffness * error;
    return inertia_[Index(dof)] * wanted;
  }

  /// How far the joint is from the model's own pose, along the path.
  double Value(const Path& path) const {
    return -Errors(path.joint, path.axis, 0)[Index(path.axis)];
  }

  void Look(const Path& path, Driven& driven) {
    driven.blown_up = HasBlownUp(d_);
    const double value = Value(path);
    if (looks_) {
      lowest_ = std::min(lowest_, value);
      highest_ = std::max(highest_, value);
    }
    for (int i = 0; i < d_.ncon; ++i) {
      const mjContact& contact = d_.contact[i];
      const int body1 = m_.geom_bodyid[contact.geom1];
      const int body2 = m_.geom_bodyid[contact.geom2];
      const int root = m_.body_rootid[m_.jnt_bodyid[path.joint]];
      if (m_.body_rootid[body1] != root || m_.body_rootid[body2] != root) continue;
      if (-contact.dist <= driven.measured.penetration) continue;
      driven.measured.penetration = -contact.dist;
      driven.body1 = compiled::NameOf(m_, mjOBJ_BODY, std::min(body1, body2));
      driven.body2 = compiled::NameOf(m_, mjOBJ_BODY, std::max(body1, body2));
      driven.where = value;
    }
  }

  const mjModel& m_;
  mjData& d_;
  std::span<const mjtNum> start_;  // nq
  std::vector<bool> coupled_;      // joints that other elements may move along
  std::vector<Coupling> couplings_;
  std::vector<double> inertia_;
  bool looks_ = true;  // whether what is beyond the range counts
  double lowest_ = 0;
  double highest_ = 0;
};

/// The model without gravity, passive forces, floor and loose roots.
engine::Model Hold(const mjModel& model) {
  engine::Model held(mj_copyModel(nullptr, &model));
  mjModel& m = *held;
  // Springs, friction and actuators have no part in where a joint can go.
  m.opt.disableflags |= mjDSBL_GRAVITY | mjDSBL_PASSIVE | mjDSBL_FRICTIONLOSS | mjDSBL_ACTUATION;
  for (int i = 0; i < m.njnt; ++i) {
    if (m.jnt_type[i] != mjJNT_FREE) continue;
    const int body = m.jnt_bodyid[i];
    double size = 0;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_rootid[m.geom_bodyid[geom]] == body) size = std::max(size, m.geom_rbound[geom]);
    }
    const double mass = kHeld * m.body_subtreemass[body];
    for (int k = 0; k < 6; ++k)
      m.dof_armature[m.jnt_dofadr[i] + k] += k < 3 ? mass : mass * size * size;
  }
  for (int i = 0; i < m.ngeom; ++i) {
    if (m.geom_bodyid[i] == 0 && m.geom_type[i] == mjGEOM_PLANE)
      m.geom_contype[i] = m.geom_conaffinity[i] = 0;
  }
  return held;
}

}  // namespace

std::vector<Driven> DriveJoints(const mjModel& m, mjData& d) {
  std::vector<int> joints;
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (!PathsOf(m, joint).empty()) joints.push_back(joint);
  }
  std::vector<Driven> all;
  if (joints.empty()) return all;
  const engine::Model held = Hold(m);
  Driver driver(*held, d);
  for (const int joint : joints) all.push_back(driver.Run(joint));
  return all;
}

}  // namespace mjforge::physics
