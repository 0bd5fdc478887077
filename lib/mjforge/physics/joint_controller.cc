// Controller that drives joints: smooth moves, by inverse dynamics with critically damped feedback
// of errors.
#include "mjforge/physics/joint_controller.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

using compiled::Index;

constexpr double kMoveTime = 0.5;    // s, shortest duration of a move
constexpr double kFastest = 12;      // rad/s, highest speed of a hinge
constexpr double kLongestMove = 10;  // s
constexpr double kHoldTime = 0.1;    // s; a move ends if the joint comes no nearer for this time
constexpr double kMostWaiting = 1;   // s, longest wait for a joint that lags behind the setpoint
// Largest distance from the end of a move at which the move is complete: a share of the range, but
// at most kNearest, because the range of a screw is many turns.
constexpr double kThere = 0.01;
constexpr double kNearest = 0.005;  // rad or m
// Natural frequency of the feedback, rad/s: slower than the 50 rad/s of MuJoCo's limits and
// contacts, and faster than a move.
constexpr double kNaturalFrequency = 20;
// Largest position errors that the feedback corrects. Larger errors are clamped, to limit the force
// on a blocked joint. kMostError is a share of the range of a driven joint; kMostHeldError applies
// to joints that are held.
constexpr double kMostError = 0.1;
constexpr double kMostHeldError = 0.1;  // rad or m

/// Returns the duration, s, of a move of a hinge by `angle`. The speed is at most kFastest, unless
/// the move would take longer than kLongestMove; a screw must not reach the end of its range at a
/// high speed.
double TimeOf(double angle) {
  return std::clamp(std::numbers::pi / 2 * std::abs(angle) / kFastest, kMoveTime, kLongestMove);
}

/// Returns the setpoint at a time, s, of a smooth move from 0 to 1 (half a cosine wave) in
/// `duration` s.
Setpoint SmoothMove(double time, double duration) {
  const double share = std::clamp(time / duration, 0.0, 1.0);
  if (share >= 1) return {1, 0, 0};
  const double phase = std::numbers::pi * share;
  const double rate = std::numbers::pi / duration;
  return {(1 - std::cos(phase)) / 2, rate * std::sin(phase) / 2, rate * rate * std::cos(phase) / 2};
}

}  // namespace

JointController::JointController(mjModel& m, mjData& d, CoupledJoints coupled)
    : m_(m),
      d_(d),
      coupled_(coupled),
      couplings_(m),
      added_inertia_(Index(m.nv)),
      accelerations_(Index(m.nv)),
      is_pushed_(Index(m.nv)),
      stepper_(m, d) {}

void JointController::Begin(std::span<const mjtNum> start) {
  start_.assign(start.begin(), start.end());
  Reset();
  initial_depths_ = DepthsNow();
}

std::vector<InitialPenetration> JointController::InitialPenetrations() const {
  std::vector<InitialPenetration> penetrations;
  for (const auto& [bodies, depth] : initial_depths_)
    if (AreOneTree(bodies)) penetrations.push_back({bodies.first, bodies.second, depth});
  return penetrations;
}

std::vector<DrivenJoint> JointController::Run(std::span<const int> joints) {
  std::vector<DrivenJoint> all(joints.size());
  std::vector<std::vector<JointPath>> paths;
  std::size_t most = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    all[i].joint = joints[i];
    all[i].measured.name = compiled::NameOf(m_, mjOBJ_JOINT, joints[i]);
    paths.push_back(PathsOf(m_, joints[i], start_));
    if (coupled_ == CoupledJoints::kPassive)
      for (JointPath& path : paths.back()) path.push = 0;  // this drive does not test limits
    most = std::max(most, paths.back().size());
  }
  for (std::size_t k = 0; k < most; ++k) {
    std::vector<JointDrive> drives;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (k < paths[i].size())
        drives.push_back(
            {.path = paths[i][k], .driven = &all[i], .moved = BodiesMovedBy(m_, joints[i])});
    }
    DriveAll(drives);
  }
  return all;
}

void JointController::Reset() {
  mj_resetData(&m_, &d_);
  std::ranges::copy(start_, d_.qpos);
  mj_forward(&m_, &d_);
}

std::map<JointController::Bodies, double> JointController::DepthsNow() const {
  std::map<Bodies, double> depths;
  for (const mjContact& contact : ContactsOf(d_)) {
    const int body1 = m_.geom_bodyid[contact.geom1];
    const int body2 = m_.geom_bodyid[contact.geom2];
    if (!(contact.dist < 0)) continue;
    double& depth = depths[std::minmax({body1, body2})];
    depth = std::max(depth, -contact.dist);
  }
  return depths;
}

void JointController::DriveAll(std::vector<JointDrive>& drives) {
  Reset();
  for (const JointDrive& drive : drives) {
    if (m_.jnt_type[drive.path.joint] != mjJNT_BALL) continue;
    const int at = m_.jnt_qposadr[drive.path.joint];
    std::copy_n(m_.qpos0 + at, 4, d_.qpos + at);
  }
  mj_forward(&m_, &d_);
  std::ranges::fill(added_inertia_, 0.0);
  for (JointDrive& drive : drives) Start(drive);
  const auto move = [&](double JointDrive::*from, double JointPath::*end, double sign) {
    for (JointDrive& drive : drives) {
      drive.from = drive.*from;
      drive.to = drive.path.*end + sign * drive.path.push;
    }
    Move(drives);
    for (JointDrive& drive : drives) drive.counts = true;
  };
  move(&JointDrive::from, &JointPath::low, -1);
  move(&JointDrive::to, &JointPath::high, 1);
  for (JointDrive& drive : drives) {
    drive.from = drive.to;
    drive.to = drive.home;
  }
  Move(drives);
  for (const JointDrive& drive : drives) Finish(drive);
}

void JointController::Start(JointDrive& drive) {
  const JointPath& path = drive.path;
  const int dof = m_.jnt_dofadr[path.joint] + path.axis;
  added_inertia_[Index(dof)] = AddedInertiaOf(dof);
  drive.driven->range = std::max(drive.driven->range, path.range());
  drive.driven->outside = std::max({0.0, path.low - path.start, path.start - path.high});
  // Limits push a joint that starts outside of its range into the range, which therefore contains
  // `home`.
  drive.home = std::clamp(path.start, path.low, path.high);
  drive.lowest = drive.highest = drive.home;
  drive.counts = drive.driven->outside == 0;
  drive.from = path.start;
}

void JointController::Finish(const JointDrive& drive) {
  const JointPath& path = drive.path;
  const double reached = std::min(drive.highest, path.high) - std::max(drive.lowest, path.low);
  Result::Joint& measured = drive.driven->measured;
  // Leaves the reach of a coupled joint without a range unchanged, because such a joint, for
  // example the rocker of a linkage, need not make the full turn of its path.
  const bool has_own_range = path.limited || !couplings_.IsCoupled(path.joint);
  if (path.range() > 0 && has_own_range)
    measured.reach = std::min(measured.reach, std::max(reached, 0.0) / path.range());
  if (path.limited) {
    measured.overshoot =
        std::max({measured.overshoot, path.low - drive.lowest, drive.highest - path.high});
  }
  measured.return_error = std::max(measured.return_error, std::abs(Value(path) - drive.home));
}

void JointController::Move(std::vector<JointDrive>& drives) {
  const double dt = m_.opt.timestep;
  double duration = kMoveTime;
  for (JointDrive& drive : drives) {
    drive.nearest = std::abs(Value(drive.path) - drive.End());
    drive.held = 0;
    if (m_.jnt_type[drive.path.joint] != mjJNT_SLIDE)
      duration = std::max(duration, TimeOf(drive.to - drive.from));
  }
  const auto is_done = [&](const JointDrive& drive) {
    return drive.held >= kHoldTime || drive.driven->has_diverged;
  };
  for (double time = 0; time < duration + kHoldTime + kMostWaiting; time += dt) {
    if (std::ranges::all_of(drives, is_done)) return;
    SetForces(drives, SmoothMove(time, duration));
    stepper_.Step();
    Measure(drives);
    for (JointDrive& drive : drives) {
      const double distance = std::abs(Value(drive.path) - drive.End());
      const double near = std::min(kThere * drive.path.range(), kNearest);
      // A joint that creeps nearer, or swings about the end of the move, still moves.
      const double speed = std::abs(d_.qvel[m_.jnt_dofadr[drive.path.joint] + drive.path.axis]);
      const bool moves =
          distance > near && (distance < drive.nearest - near * dt || speed > near / kHoldTime);
      drive.nearest = std::min(drive.nearest, distance);
      drive.held = time < duration || moves ? 0 : drive.held + dt;
    }
  }
}

/// Returns the inertia, kg or kg m^2, that equalities and tendons add to a degree of freedom; for
/// example, a screw must also accelerate the lid that it lifts. Measures the inertia with a test
/// force.
double JointController::AddedInertiaOf(int dof) {
  const double held = engine::DofInertia(m_, d_, dof);
  const double force = held;  // for an acceleration of about 1 m/s^2 or rad/s^2
  mj_forward(&m_, &d_);
  const double idle = d_.qacc[dof];
  double gained = 0;
  for (const double sign : {-1.0, 1.0}) {  // a limit may block one direction
    d_.qfrc_applied[dof] = sign * force;
    mj_forward(&m_, &d_);
    gained = std::max(gained, sign * (d_.qacc[dof] - idle));
  }
  d_.qfrc_applied[dof] = 0;
  return gained > 0 ? std::max(force / gained - held, 0.0) : 0;
}

void JointController::SetForces(const std::vector<JointDrive>& drives, const Setpoint& progress) {
  std::ranges::fill(accelerations_, 0.0);
  is_pushed_.assign(is_pushed_.size(), false);
  for (int joint = 0; joint < m_.njnt; ++joint) {
    if (m_.jnt_type[joint] == mjJNT_FREE) continue;
    const auto drive =
        std::ranges::find(drives, joint, [](const JointDrive& r) { return r.path.joint; });
    if (drive != drives.end()) {
      const JointPath& path = drive->path;
      Correct(joint, path.axis, Errors(joint, path.axis, Target(*drive, progress).position),
              kMostError * path.range(), Target(*drive, progress));
    } else if (const std::optional<Setpoint> held = SetpointOfOther(drives, joint, progress)) {
      Correct(joint, 0, ErrorsOfHeld(joint, held->position), kMostHeldError, *held);
    }
  }
  ApplyForces();
}

/// Applies the forces that would give the desired accelerations to joints at rest without gravity.
/// Computes them from the whole mass matrix, because each link of a chain feels the forces on the
/// other links.
void JointController::ApplyForces() {
  mj_mulM(&m_, &d_, d_.qfrc_applied, accelerations_.data());
  for (int i = 0; i < m_.nv; ++i) {
    const double added = added_inertia_[Index(i)] * accelerations_[Index(i)];
    d_.qfrc_applied[i] = is_pushed_[Index(i)] ? d_.qfrc_applied[i] + added : 0;
  }
}

Setpoint JointController::Target(const JointDrive& drive, const Setpoint& progress) {
  const double way = drive.to - drive.from;
  return {drive.from + way * progress.position, way * progress.speed, way * progress.acceleration};
}

/// Returns the setpoint of a joint that is not driven; nullopt if couplings to other joints move
/// the joint.
std::optional<Setpoint> JointController::SetpointOfOther(const std::vector<JointDrive>& drives,
                                                         int joint,
                                                         const Setpoint& progress) const {
  const int at = m_.jnt_qposadr[joint];
  if (!couplings_.IsCoupled(joint)) return Setpoint{start_[Index(at)] - m_.qpos0[at], 0, 0};
  if (coupled_ == CoupledJoints::kPassive) return std::nullopt;
  for (const JointDrive& drive : drives) {
    const auto setpoint = couplings_.SetpointOf(joint, drive.path.joint, Target(drive, progress));
    if (setpoint) return setpoint;
  }
  return std::nullopt;
}

/// Sets the desired accelerations of a joint, from feedback of the position errors `errors`,
/// clamped to `most`, and of speed errors. The setpoint moves about `axis`; about the other axes of
/// a ball joint, the setpoint is at rest.
void JointController::Correct(int joint, int axis, const std::array<double, 3>& errors, double most,
                              const Setpoint& setpoint) {
  const int dofs = m_.jnt_type[joint] == mjJNT_BALL ? 3 : 1;
  for (int i = 0; i < dofs; ++i) {
    const int dof = m_.jnt_dofadr[joint] + i;
    const double error = std::clamp(errors[Index(i)], -most, most);
    is_pushed_[Index(dof)] = true;
    const Setpoint at = i == axis ? setpoint : Setpoint();
    // Critically damped feedback of the position error and the speed error.
    accelerations_[Index(dof)] = at.acceleration +
                                 2 * kNaturalFrequency * (at.speed - d_.qvel[dof]) +
                                 kNaturalFrequency * kNaturalFrequency * error;
  }
}

/// Returns the position errors of the degrees of freedom of a joint (three of a ball joint,
/// otherwise the first number), m or rad. `target` is relative to qpos0, for a ball joint about
/// `axis`.
std::array<double, 3> JointController::Errors(int joint, int axis, double target) const {
  const int at = m_.jnt_qposadr[joint];
  if (m_.jnt_type[joint] != mjJNT_BALL) return {m_.qpos0[at] + target - d_.qpos[at], 0, 0};
  const std::array<mjtNum, 4> wanted =
      compiled::BallAt(m_, joint, Eigen::Vector3d::Unit(axis), target);
  std::array<double, 3> errors = {};
  mju_subQuat(errors.data(), wanted.data(), d_.qpos + at);
  return errors;
}

std::array<double, 3> JointController::ErrorsOfHeld(int joint, double target) const {
  if (m_.jnt_type[joint] != mjJNT_BALL) return Errors(joint, 0, target);
  const int at = m_.jnt_qposadr[joint];
  std::array<double, 3> errors = {};
  mju_subQuat(errors.data(), &start_[Index(at)], d_.qpos + at);
  return errors;
}

/// Returns the position of the joint along the path, relative to qpos0.
double JointController::Value(const JointPath& path) const {
  return -Errors(path.joint, path.axis, 0)[Index(path.axis)];
}

void JointController::Measure(std::vector<JointDrive>& drives) {
  const bool has_diverged = HasDiverged(d_);
  const std::map<Bodies, double> depths = DepthsNow();
  for (JointDrive& drive : drives) {
    drive.driven->has_diverged = drive.driven->has_diverged || has_diverged;
    MeasureEqualities(*drive.driven);
    const double value = Value(drive.path);
    if (drive.counts) {
      drive.lowest = std::min(drive.lowest, value);
      drive.highest = std::max(drive.highest, value);
    }
    for (const auto& [bodies, depth] : depths) {
      const auto initial = initial_depths_.find(bodies);
      const double deeper = depth - (initial != initial_depths_.end() ? initial->second : 0);
      if (!AreOneTree(bodies)) {
        if (drive.moved[Index(bodies.first)] || drive.moved[Index(bodies.second)])
          NoteFreeBody(bodies, deeper, *drive.driven);
        continue;
      }
      // If one joint is driven, counts all pairs of bodies of its tree for this joint. If several
      // joints are driven, counts a pair for each joint that moves one of the two bodies.
      const bool is_own =
          drives.size() == 1
              ? m_.body_rootid[bodies.first] == m_.body_rootid[m_.jnt_bodyid[drive.path.joint]]
              : drive.moved[Index(bodies.first)] || drive.moved[Index(bodies.second)];
      if (!is_own || deeper <= drive.driven->measured.penetration) continue;
      drive.driven->measured.penetration = deeper;
      drive.driven->body1 = compiled::NameOf(m_, mjOBJ_BODY, bodies.first);
      drive.driven->body2 = compiled::NameOf(m_, mjOBJ_BODY, bodies.second);
      drive.driven->where = value;
    }
  }
}

void JointController::MeasureEqualities(DrivenJoint& driven) const {
  driven.equality_errors.resize(Index(m_.neq));
  for (int row = 0; row < d_.nefc; ++row) {
    if (d_.efc_type[row] != mjCNSTR_EQUALITY) continue;
    double& error = driven.equality_errors[Index(d_.efc_id[row])];
    error = std::max(error, std::abs(d_.efc_pos[row]));
  }
}

bool JointController::AreOneTree(const Bodies& bodies) const {
  return m_.body_rootid[bodies.first] == m_.body_rootid[bodies.second];
}

void JointController::NoteFreeBody(const Bodies& bodies, double depth, DrivenJoint& driven) const {
  if (depth <= driven.free_depth) return;
  driven.free_depth = depth;
  driven.free_pair = {compiled::NameOf(m_, mjOBJ_BODY, bodies.first),
                      compiled::NameOf(m_, mjOBJ_BODY, bodies.second)};
}

}  // namespace mjforge::physics
