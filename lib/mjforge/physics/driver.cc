#include "mjforge/physics/driver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

constexpr std::size_t Index(int i) { return static_cast<std::size_t>(i); }

constexpr double kMoveTime = 0.5;    // s, from one end to the other
constexpr double kFastest = 12;      // rad/s
constexpr double kLongestMove = 10;  // s
constexpr double kHoldTime = 0.1;    // s, at an end, once it is there or no longer comes nearer
constexpr double kMostWaiting = 1;   // s, for what follows slowly
constexpr double kThere = 0.01;      // of the range
constexpr double kVeryNear = 0.005;  // rad or m, if that is less: a screw's range is many turns
// How fast errors are to vanish, rad/s: slow beside the 50 rad/s of MuJoCo's own
// limits and contacts, fast beside a move.
constexpr double kStiffness = 20;
// An error counts up to so much of the range, so that what is stuck is not crushed; of a joint
// that is held, up to kMostHeld.
constexpr double kMostError = 0.1;
constexpr double kMostHeld = 0.1;  // rad or m

/// How long a move takes, s: a screw makes its turns no faster than kFastest, so that it does not
/// hit the end like a flywheel.
double TimeOf(double angle) {
  return std::clamp(std::numbers::pi / 2 * std::abs(angle) / kFastest, kMoveTime, kLongestMove);
}

/// From 0 to 1 without a jolt, in `duration` s.
Move MoveAt(double time, double duration) {
  const double share = std::clamp(time / duration, 0.0, 1.0);
  if (share >= 1) return {1, 0, 0};
  const double phase = std::numbers::pi * share;
  const double rate = std::numbers::pi / duration;
  return {(1 - std::cos(phase)) / 2, rate * std::sin(phase) / 2, rate * rate * std::cos(phase) / 2};
}

}  // namespace

Driver::Driver(mjModel& m, mjData& d)
    : m_(m), d_(d), couplings_(m), inertia_(Index(m.nv)), stepper_(m, d) {}

void Driver::Begin(std::span<const mjtNum> start) {
  start_.assign(start.begin(), start.end());
  Reset();
  jams_ = DepthsNow();
}

std::vector<Jam> Driver::Jams() const {
  std::vector<Jam> jams;
  for (const auto& [bodies, depth] : jams_) jams.push_back({bodies.first, bodies.second, depth});
  return jams;
}

std::vector<Driven> Driver::Run(std::span<const int> joints) {
  std::vector<Driven> all(joints.size());
  std::vector<std::vector<Path>> paths;
  std::size_t most = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    all[i].joint = joints[i];
    all[i].measured.name = compiled::NameOf(m_, mjOBJ_JOINT, joints[i]);
    paths.push_back(PathsOf(m_, joints[i], start_));
    most = std::max(most, paths.back().size());
  }
  for (std::size_t k = 0; k < most; ++k) {
    std::vector<Ride> rides;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (k < paths[i].size())
        rides.push_back({.path = paths[i][k], .driven = &all[i], .moved = MovedBy(m_, joints[i])});
    }
    Follow(rides);
  }
  return all;
}

void Driver::Reset() {
  mj_resetData(&m_, &d_);
  std::ranges::copy(start_, d_.qpos);
  mj_forward(&m_, &d_);
}

std::map<Driver::Bodies, double> Driver::DepthsNow() const {
  std::map<Bodies, double> depths;
  for (int i = 0; i < d_.ncon; ++i) {
    const mjContact& contact = d_.contact[i];
    const int body1 = m_.geom_bodyid[contact.geom1];
    const int body2 = m_.geom_bodyid[contact.geom2];
    if (m_.body_rootid[body1] != m_.body_rootid[body2] || !(contact.dist < 0)) continue;
    double& depth = depths[std::minmax({body1, body2})];
    depth = std::max(depth, -contact.dist);
  }
  return depths;
}

void Driver::Follow(std::vector<Ride>& rides) {
  Reset();
  for (const Ride& ride : rides) {
    if (m_.jnt_type[ride.path.joint] != mjJNT_BALL) continue;
    const int at = m_.jnt_qposadr[ride.path.joint];
    std::copy_n(m_.qpos0 + at, 4, d_.qpos + at);
  }
  mj_forward(&m_, &d_);
  for (int i = 0; i < m_.nv; ++i) inertia_[Index(i)] = engine::DofInertia(m_, d_, i);
  for (Ride& ride : rides) Start(ride);
  const auto move = [&](double Ride::*from, double Path::*end, double sign) {
    for (Ride& ride : rides) {
      ride.from = ride.*from;
      ride.to = ride.path.*end + sign * ride.path.push;
    }
    Go(rides);
    for (Ride& ride : rides) ride.counts = true;
  };
  move(&Ride::from, &Path::low, -1);
  move(&Ride::to, &Path::high, 1);
  for (Ride& ride : rides) {
    ride.from = ride.to;
    ride.to = ride.home;
  }
  Go(rides);
  for (const Ride& ride : rides) Finish(ride);
}

void Driver::Start(Ride& ride) {
  const Path& path = ride.path;
  const int dof = m_.jnt_dofadr[path.joint] + path.axis;
  inertia_[Index(dof)] = InertiaOf(dof);
  ride.driven->range = std::max(ride.driven->range, path.range());
  ride.driven->outside = std::max({0.0, path.low - path.start, path.start - path.high});
  // A joint that starts outside its range is pushed in by its limits first.
  ride.home = std::clamp(path.start, path.low, path.high);
  ride.lowest = ride.highest = ride.home;
  ride.counts = ride.driven->outside == 0;
  ride.from = path.start;
}

void Driver::Finish(const Ride& ride) {
  const Path& path = ride.path;
  const double reached = std::min(ride.highest, path.high) - std::max(ride.lowest, path.low);
  Result::Joint& measured = ride.driven->measured;
  if (path.range() > 0)
    measured.reach = std::min(measured.reach, std::max(reached, 0.0) / path.range());
  if (path.limited) {
    measured.overshoot =
        std::max({measured.overshoot, path.low - ride.lowest, ride.highest - path.high});
  }
  measured.return_error = std::max(measured.return_error, std::abs(Value(path) - ride.home));
}

void Driver::Go(std::vector<Ride>& rides) {
  const double dt = m_.opt.timestep;
  double duration = kMoveTime;
  for (Ride& ride : rides) {
    ride.nearest = std::abs(Value(ride.path) - ride.End());
    ride.held = 0;
    if (m_.jnt_type[ride.path.joint] != mjJNT_SLIDE)
      duration = std::max(duration, TimeOf(ride.to - ride.from));
  }
  const auto is_done = [&](const Ride& ride) {
    return ride.held >= kHoldTime || ride.driven->blown_up;
  };
  for (double time = 0; time < duration + kHoldTime + kMostWaiting; time += dt) {
    if (std::ranges::all_of(rides, is_done)) return;
    SetForces(rides, MoveAt(time, duration));
    stepper_.Step();
    Look(rides);
    for (Ride& ride : rides) {
      const double distance = std::abs(Value(ride.path) - ride.End());
      const double near = std::min(kThere * ride.path.range(), kVeryNear);
      // It creeps nearer, or swings about its end.
      const double speed = std::abs(d_.qvel[m_.jnt_dofadr[ride.path.joint] + ride.path.axis]);
      const bool moves =
          distance > near && (distance < ride.nearest - near * dt || speed > near / kHoldTime);
      ride.nearest = std::min(ride.nearest, distance);
      ride.held = time < duration || moves ? 0 : ride.held + dt;
    }
  }
}

/// What a force on a degree of freedom has to move: with all other joints held, or with
/// what equalities and tendons make move along, as a screw's turning with its lift. A
/// test force tells.
double Driver::InertiaOf(int dof) {
  const double held = engine::DofInertia(m_, d_, dof);
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

void Driver::SetForces(const std::vector<Ride>& rides, const Move& progress) {
  std::fill_n(d_.qfrc_applied, m_.nv, 0.0);
  for (int joint = 0; joint < m_.njnt; ++joint) {
    if (m_.jnt_type[joint] == mjJNT_FREE) continue;
    const auto ride = std::ranges::find(rides, joint, [](const Ride& r) { return r.path.joint; });
    if (ride != rides.end()) {
      const Path& path = ride->path;
      Push(joint, path.axis, Errors(joint, path.axis, Target(*ride, progress).at),
           kMostError * path.range(), Target(*ride, progress));
    } else if (const std::optional<Move> move = MoveOfOther(rides, joint, progress)) {
      Push(joint, 0, ErrorsOfHeld(joint, move->at), kMostHeld, *move);
    }
  }
}

Move Driver::Target(const Ride& ride, const Move& progress) {
  const double way = ride.to - ride.from;
  return {ride.from + way * progress.at, way * progress.speed, way * progress.acceleration};
}

/// Where a joint that is not driven is to be: nothing if it may go where others take it.
std::optional<Move> Driver::MoveOfOther(const std::vector<Ride>& rides, int joint,
                                        const Move& progress) const {
  if (!couplings_.IsCoupled(joint)) return Move{StartOf(joint), 0, 0};
  for (const Ride& ride : rides) {
    const auto move = couplings_.MoveOf(joint, ride.path.joint, Target(ride, progress));
    if (move) return move;
  }
  return std::nullopt;
}

/// `move` is along one axis of a ball; about the others it rests.
void Driver::Push(int joint, int axis, const std::array<double, 3>& errors, double most,
                  const Move& move) {
  const int dofs = m_.jnt_type[joint] == mjJNT_BALL ? 3 : 1;
  for (int i = 0; i < dofs; ++i) {
    const int dof = m_.jnt_dofadr[joint] + i;
    const double error = std::clamp(errors[Index(i)], -most, most);
    d_.qfrc_applied[dof] =
        Force(dof, error, i == axis ? move.speed : 0, i == axis ? move.acceleration : 0);
  }
}

/// Distance to go, of the one or three degrees of freedom of a joint.
std::array<double, 3> Driver::Errors(int joint, int axis, double target) const {
  const int at = m_.jnt_qposadr[joint];
  if (m_.jnt_type[joint] != mjJNT_BALL) return {m_.qpos0[at] + target - d_.qpos[at], 0, 0};
  const std::array<mjtNum, 4> wanted =
      compiled::BallAt(m_, joint, Eigen::Vector3d::Unit(axis), target);
  std::array<double, 3> errors = {};
  mju_subQuat(errors.data(), wanted.data(), d_.qpos + at);
  return errors;
}

std::array<double, 3> Driver::ErrorsOfHeld(int joint, double target) const {
  if (m_.jnt_type[joint] != mjJNT_BALL) return Errors(joint, 0, target);
  const int at = m_.jnt_qposadr[joint];
  std::array<double, 3> errors = {};
  mju_subQuat(errors.data(), &start_[Index(at)], d_.qpos + at);
  return errors;
}

/// Of a joint that is not a ball, from the model's own pose.
double Driver::StartOf(int joint) const {
  const int at = m_.jnt_qposadr[joint];
  return start_[Index(at)] - m_.qpos0[at];
}

double Driver::Force(int dof, double error, double speed, double acceleration) const {
  // Critically damped.
  const double wanted =
      acceleration + 2 * kStiffness * (speed - d_.qvel[dof]) + kStiffness * kStiffness * error;
  return inertia_[Index(dof)] * wanted;
}

/// How far the joint is from the model's own pose, along the path.
double Driver::Value(const Path& path) const {
  return -Errors(path.joint, path.axis, 0)[Index(path.axis)];
}

void Driver::Look(std::vector<Ride>& rides) {
  const bool has_blown_up = HasBlownUp(d_);
  const std::map<Bodies, double> depths = DepthsNow();
  for (Ride& ride : rides) {
    ride.driven->blown_up = ride.driven->blown_up || has_blown_up;
    const double value = Value(ride.path);
    if (ride.counts) {
      ride.lowest = std::min(ride.lowest, value);
      ride.highest = std::max(ride.highest, value);
    }
    for (const auto& [bodies, depth] : depths) {
      // Of joints that move at the same time each has its own bodies.
      const bool is_own =
          rides.size() == 1
              ? m_.body_rootid[bodies.first] == m_.body_rootid[m_.jnt_bodyid[ride.path.joint]]
              : ride.moved[Index(bodies.first)] || ride.moved[Index(bodies.second)];
      const auto jam = jams_.find(bodies);
      const double deeper = depth - (jam != jams_.end() ? jam->second : 0);
      if (!is_own || deeper <= ride.driven->measured.penetration) continue;
      ride.driven->measured.penetration = deeper;
      ride.driven->body1 = compiled::NameOf(m_, mjOBJ_BODY, bodies.first);
      ride.driven->body2 = compiled::NameOf(m_, mjOBJ_BODY, bodies.second);
      ride.driven->where = value;
    }
  }
}

}  // namespace mjforge::physics
