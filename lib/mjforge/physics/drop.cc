// Drop test: simulates until the object rests, and measures drift, tilt, contacts and energy.
#include "mjforge/physics/drop.h"

#include <algorithm>
#include <cmath>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/joint_rest.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;

// Time for which all bodies must be slow to count as at rest. A pendulum is slow for a shorter time
// at its turning points, and a falling body soon gets faster.
constexpr double kRestTime = 0.1;          // s
constexpr double kMeasureInterval = 0.01;  // s

class DropSimulation {
 public:
  DropSimulation(mjModel& m, mjData& d, const model::Checks& checks, const Nudge& nudge,
                 Result& result, FilmRecorder* recorder)
      : m_(m), d_(d), checks_(checks), nudge_(nudge), result_(result), stepper_(m, d) {
    for (const int body : FreeBodies(m)) roots_.emplace_back().body = body;
    stepper_.RecordTo(recorder);
  }

  DropOutcome Run() {
    compiled::CopyStart(m_, d_);
    mj_kinematics(&m_, &d_);
    Lean();
    const Ground ground = GroundOf(m_, d_);
    result_.dropped = !roots_.empty() && ground.planes + ground.others > 0;
    // A nudged object starts on the floor, so that it gets no energy from a fall.
    const double above = IsNudged() ? LargestMargin(m_) : DropHeight(m_);
    if (result_.dropped && ground.is_level_floor())
      result_.dropped = LiftFreeBodies(m_, d_, ground.height + above);
    mj_forward(&m_, &d_);
    Begin();
    const int most = static_cast<int>(std::ceil(checks_.settle_time / m_.opt.timestep));
    const int interval =
        std::max(1, static_cast<int>(std::lround(kMeasureInterval / m_.opt.timestep)));
    const double steps_at_rest = kRestTime / m_.opt.timestep;
    int slow = 0;
    int step = 0;
    while (step < most && (slow < steps_at_rest || MayStillMove()) && !HasDiverged(d_) &&
           !IsCrowded(d_)) {
      for (int i = 0; i < interval && step < most; ++i, ++step) {
        stepper_.Step();
        CountContacts();
      }
      slow = FindFastestBody(m_, d_).speed < checks_.rest_speed ? slow + interval : 0;
      highest_energy_ = std::max(highest_energy_, Energy());
    }
    result_.at_rest = slow >= steps_at_rest;
    result_.time = step * m_.opt.timestep;
    End();
    return {HasDiverged(d_), WarningsOf(d_), compiled::NameOf(m_, mjOBJ_BODY, fastest_),
            (VectorAt(d_.xipos, fastest_) - VectorAt(starts_.data(), fastest_)).norm()};
  }

 private:
  /// A free body, which is the root of a tree of bodies.
  struct Root {
    int body = 0;
    Eigen::Vector3d start = Eigen::Vector3d::Zero();  // m, centre of mass of the tree
    Eigen::Vector3d up_B =
        Eigen::Vector3d::UnitZ();  // world's z axis in frame B of the body, before the nudge
  };

  bool IsNudged() const { return nudge_.tilt != 0 || nudge_.speed != 0; }

  /// Returns true if an object whose bodies are slow may not be at rest: a nudged object may be
  /// balancing, and a damped joint may creep.
  bool MayStillMove() const {
    if (IsNudged()) return Tilt() > checks_.nudge / 2;
    return HasRestRanges(checks_);
  }

  /// Returns the largest angle, over all free bodies, between the vertical and the direction of the
  /// body that was up before the nudge (Root::up_B), rad.
  double Tilt() const {
    double tilt = 0;
    for (const Root& root : roots_) {
      const double up = (TurnOf(root.body) * root.up_B).z();
      tilt = std::max(tilt, std::acos(std::clamp(up, -1.0, 1.0)));
    }
    return tilt;
  }

  /// Applies the nudge: tilts the free bodies and gives them a speed.
  void Lean() {
    if (!IsNudged()) return;
    mj_comPos(&m_, &d_);
    const Eigen::Vector3d way(std::cos(nudge_.azimuth), std::sin(nudge_.azimuth), 0);
    lean_ = Eigen::AngleAxisd(nudge_.tilt, Eigen::Vector3d::UnitZ().cross(way));
    for (const Root& root : roots_) {
      const int joint = m_.body_jntadr[root.body];
      mjtNum* const qpos = d_.qpos + m_.jnt_qposadr[joint];
      const Eigen::Vector3d center = VectorAt(d_.subtree_com, root.body);
      const Eigen::Vector3d p = center + lean_ * (VectorAt(qpos, 0) - center);
      compiled::WritePose({p, lean_ * TurnOf(root.body)}, qpos, qpos + 3);
      Eigen::Map<Eigen::Vector3d>(d_.qvel + m_.jnt_dofadr[joint]) = nudge_.speed * way;
    }
    mj_kinematics(&m_, &d_);
  }

  Eigen::Quaterniond TurnOf(int body) const { return compiled::QuaternionAt(d_.xquat, body); }

  /// Stores the poses and the energy at the start, and computes the scale of energy gains.
  void Begin() {
    starts_.assign(d_.xipos, d_.xipos + 3 * m_.nbody);
    for (Root& root : roots_) {
      root.start = VectorAt(d_.subtree_com, root.body);
      root.up_B = TurnOf(root.body).conjugate() * (lean_ * Eigen::Vector3d::UnitZ());
    }
    // Energy that lifts the object by its own size, J. Energy gains are shares of this energy.
    double radius = 0;
    for (int i = 0; i < m_.ngeom; ++i) {
      if (m_.geom_bodyid[i] != 0) radius = std::max(radius, Reach(i));
    }
    const double gravity = Eigen::Map<const Eigen::Vector3d>(m_.opt.gravity).norm();
    energy_scale_ = m_.body_subtreemass[0] * (gravity > 0 ? gravity : 9.81) * 2 * radius;
    start_energy_ = highest_energy_ = Energy();
  }

  /// Returns an upper bound of the distance of the points of a geom from the centre of mass of its
  /// tree of bodies, m.
  double Reach(int geom) const {
    const int root = m_.body_rootid[m_.geom_bodyid[geom]];
    return m_.geom_rbound[geom] +
           (VectorAt(d_.geom_xpos, geom) - VectorAt(d_.subtree_com, root)).norm();
  }

  // Returns the potential and kinetic energy, J. Sets the energy flag only here, because MuJoCo
  // would otherwise compute the energy in every step. Updates the poses of bodies first, because
  // mj_step leaves the poses from before the step.
  double Energy() {
    compiled::UpdatePoses(m_, d_);
    const int flags = m_.opt.enableflags;
    m_.opt.enableflags |= mjENBL_ENERGY;
    mj_energyPos(&m_, &d_);
    mj_energyVel(&m_, &d_);
    m_.opt.enableflags = flags;
    return d_.energy[0] + d_.energy[1];
  }

  void CountContacts() {
    result_.ncon = std::max(result_.ncon, d_.ncon);
    result_.nefc = std::max(result_.nefc, d_.nefc);
    result_.penetration = std::max(result_.penetration, DeepestContact(d_));
  }

  void End() {
    const FastestBody fastest = FindFastestBody(m_, d_);
    fastest_ = fastest.body;
    result_.speed = fastest.speed;
    result_.sink = DeepestContact(d_);
    if (energy_scale_ > 0)
      result_.energy_gain = std::max(0.0, highest_energy_ - start_energy_) / energy_scale_;
    for (const Root& root : roots_) {
      const Eigen::Vector3d way = VectorAt(d_.subtree_com, root.body) - root.start;
      result_.drift = std::max(result_.drift, way.head<2>().norm());
    }
    result_.tilt = Tilt();
  }

  mjModel& m_;
  mjData& d_;
  const model::Checks& checks_;
  const Nudge& nudge_;
  Result& result_;
  Eigen::Quaterniond lean_ = Eigen::Quaterniond::Identity();
  std::vector<Root> roots_;
  std::vector<mjtNum> starts_;  // nbody x 3, xipos at the start
  int fastest_ = 0;             // fastest body at the end
  double start_energy_ = 0;
  double highest_energy_ = 0;
  double energy_scale_ = 0;  // J
  Stepper stepper_;
};

}  // namespace

DropOutcome SimulateDrop(mjModel& m, mjData& d, const model::Checks& checks, const Nudge& nudge,
                         Result& result, FilmRecorder* recorder) {
  return DropSimulation(m, d, checks, nudge, result, recorder).Run();
}

std::optional<int> FreeStandingBody(const mjModel& m, mjData& d) {
  mj_kinematics(&m, &d);
  const Ground ground = GroundOf(m, d);
  if (!ground.is_level_floor()) return std::nullopt;
  const std::vector<int> bodies = FreeBodies(m);
  return bodies.size() == 1 ? std::optional(bodies.front()) : std::nullopt;
}

}  // namespace mjforge::physics
