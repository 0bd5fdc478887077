// Grasp test: simulates a gripper that closes on an object, and then lifts and shakes the object or
// pulls a joint.
#include "mjforge/physics/probe_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/grasp_search.h"
#include "mjforge/physics/gripper.h"
#include "mjforge/physics/named_elements.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using Eigen::Vector3d;
using expr::RoundedText;

// Durations of the phases of a grasp. The gripper stays in place; instead of moving the gripper,
// the test changes gravity.
constexpr double kClose = 0.5;   // s
constexpr double kBounce = 0.1;  // s, longest time for which bouncing jaws may lose contact
constexpr double kLift = 0.3;    // s
constexpr double kShake = 0.2;   // s along each axis
constexpr double kHold = 2;      // s
constexpr double kOpen = 0.3;    // s
// While the jaws close, free bodies are damped as if they stood on a table. The damping lets the
// force of a jaw push a body at the speed kGiving, and turn the body at kGiving / kArm if the force
// acts at a distance of kArm from the body's centre.
constexpr double kGiving = 0.02;    // m/s
constexpr double kArm = 0.05;       // m
constexpr double kLifting = 1.5;    // load while the object is lifted, multiple of gravity
constexpr double kShaking = 0.5;    // amplitude of shaking, multiple of gravity
constexpr double kFrequency = 5;    // Hz, of shaking
constexpr double kMostSlip = 0.02;  // m, largest slip: the size of the jaws' faces
// Speed and time that define standstill. If nothing moves faster than kStillSpeed for kStillTime
// under a constant load, the object slips by less than 2 mm in the rest of kHold, and the phase
// ends early.
constexpr double kStillSpeed = 0.001;  // m/s
constexpr double kStillTime = 0.2;     // s
constexpr double kImpratio = 10;       // opt.impratio, large to reduce creep in contacts
// Prefix of the names of sites that are tried if checks.grasps names no sites.
constexpr std::string_view kSitePrefix = "grasp";

enum class GraspOutcome { kHeld, kMissed, kSlipped, kStuck, kDiverged };

/// Damps free bodies heavily until this object is destroyed.
class DampedRoots {
 public:
  DampedRoots(mjModel& m, double force) : m_(m), damping_(m.dof_damping, m.dof_damping + m.nv) {
    for (const int body : FreeBodies(m)) {
      for (int k = 0; k < 6; ++k)
        m.dof_damping[m.body_dofadr[body] + k] = force / kGiving * (k < 3 ? 1 : kArm * kArm);
    }
  }
  ~DampedRoots() { std::ranges::copy(damping_, m_.dof_damping); }
  DampedRoots(const DampedRoots&) = delete;
  DampedRoots& operator=(const DampedRoots&) = delete;

 private:
  mjModel& m_;
  std::vector<mjtNum> damping_;
};

/// Returns the first hinge or slide of the body, or of its nearest ancestor that has one; nullopt
/// if there is none.
std::optional<int> JointAbove(const mjModel& m, int body) {
  for (; body > 0; body = m.body_parentid[body]) {
    for (int i = 0; i < m.body_jntnum[body]; ++i) {
      const int joint = m.body_jntadr[body] + i;
      if (compiled::HasOneNumber(m, joint)) return joint;
    }
  }
  return std::nullopt;
}

bool HasFreeJoint(const mjModel& m, int root) {
  return m.body_jntnum[root] == 1 && m.jnt_type[m.body_jntadr[root]] == mjJNT_FREE;
}

/// Simulation of one grasp. If `joint` is set, the gripper holds a body that this joint moves, and
/// the joint is pulled in both directions; otherwise the object is lifted and shaken.
class GraspSimulation {
 public:
  GraspSimulation(mjModel& m, mjData& d, const Gripper& gripper,
                  const model::GraspingCheck& grasping, std::optional<int> joint)
      : m_(m), d_(d), gripper_(gripper), grasping_(grasping), joint_(joint), stepper_(m, d) {}

  GraspOutcome Run(const GraspCandidate& candidate, std::span<const mjtNum> start) {
    gripper_.Place(d_, start, candidate.X_WJ, OpeningFor(candidate, grasping_));
    body_ = candidate.body;
    mj_kinematics(&m_, &d_);
    p_WJ_ = candidate.X_WJ.p;
    std::optional<DampedRoots> damped(std::in_place, m_, grasping_.force);
    gripper_.Press(d_, grasping_.force);
    Gravity().setZero();
    if (!StepFor(kClose)) return GraspOutcome::kDiverged;
    if (!Touches()) return GraspOutcome::kMissed;
    p_BJ_ = BodyPose().Inverse() * p_WJ_;
    damped.reset();
    const GraspOutcome grip = joint_ ? Pull(*joint_) : Lift();
    if (grip != GraspOutcome::kHeld) return grip;
    // Gravity is off while the jaws open, so that an object wider than the grip does not lie on the
    // fingers.
    Gravity().setZero();
    gripper_.Press(d_, -grasping_.force);
    if (!StepFor(kOpen)) return GraspOutcome::kDiverged;
    return apart_ == 0 ? GraspOutcome::kStuck : GraspOutcome::kHeld;
  }

 private:
  model::Pose BodyPose() const { return compiled::PoseAt(d_.xpos, d_.xquat, body_); }
  double Slip() const { return (BodyPose() * p_BJ_ - p_WJ_).norm(); }

  Eigen::Map<Vector3d> Gravity() { return Eigen::Map<Vector3d>(m_.opt.gravity); }

  /// Advances the simulation by one step; returns false if it diverges.
  bool Step() {
    stepper_.Step();
    apart_ = gripper_.Holds(d_, m_.body_rootid[body_]) ? 0 : apart_ + m_.opt.timestep;
    still_ = FindFastestBody(m_, d_).speed < kStillSpeed ? still_ + m_.opt.timestep : 0;
    return !HasDiverged(d_);
  }

  /// Steps for a time, s; returns false if the simulation diverges.
  bool StepFor(double time) {
    for (double t = 0; t < time; t += m_.opt.timestep) {
      if (!Step()) return false;
    }
    return true;
  }

  /// Returns true if everything has been slow for kStillTime under a constant load.
  bool IsStill() const { return still_ >= kStillTime; }

  /// Returns true if both jaws touch the object, or have lost contact for less than kBounce.
  bool Touches() const { return apart_ < kBounce; }
  bool Holds() const { return Touches() && Slip() <= kMostSlip; }

  GraspOutcome Lift() {
    const Vector3d down(0, 0, -kEarthGravity);
    constexpr double kMoved = kLift + 3 * kShake;
    still_ = 0;
    for (double t = 0; t < kMoved + kHold && !IsStill(); t += m_.opt.timestep) {
      if (t < kMoved) still_ = 0;
      Vector3d g = t < kLift ? Vector3d(kLifting * down) : down;
      const int axis = static_cast<int>(std::floor((t - kLift) / kShake));
      if (t >= kLift && axis < 3)
        g[axis] += kShaking * kEarthGravity * std::sin(2 * std::numbers::pi * kFrequency * t);
      Gravity() = g;
      if (!Step()) return GraspOutcome::kDiverged;
      if (Slip() > kMostSlip) return GraspOutcome::kSlipped;
    }
    return Holds() ? GraspOutcome::kHeld : GraspOutcome::kSlipped;
  }

  /// Pulls the joint in both directions with the force grasping.pull at the gripper.
  GraspOutcome Pull(int joint) {
    Gravity() = Vector3d(0, 0, -kEarthGravity);
    const int dof = m_.jnt_dofadr[joint];
    const Vector3d axis = compiled::VectorAt(d_.xaxis, joint);
    const Vector3d arm = p_WJ_ - compiled::VectorAt(d_.xanchor, joint);
    const double lever = m_.jnt_type[joint] == mjJNT_HINGE ? axis.cross(arm).norm() : axis.norm();
    for (const double way : {1.0, -1.0}) {
      d_.qfrc_applied[dof] = way * grasping_.pull * lever;
      still_ = 0;
      for (double t = 0; t < kHold / 2 && !IsStill(); t += m_.opt.timestep) {
        if (!Step()) return GraspOutcome::kDiverged;
        if (Slip() > kMostSlip) return GraspOutcome::kSlipped;
      }
    }
    d_.qfrc_applied[dof] = 0;
    return Holds() ? GraspOutcome::kHeld : GraspOutcome::kSlipped;
  }

  mjModel& m_;
  mjData& d_;
  const Gripper& gripper_;
  const model::GraspingCheck& grasping_;
  std::optional<int> joint_;
  int body_ = 0;                      // id of the body with the first face of the grasp
  double apart_ = 0;                  // s, time since both jaws last touched the object
  double still_ = 0;                  // s, time since anything moved faster than kStillSpeed
  Vector3d p_BJ_ = Vector3d::Zero();  // m, gripper's origin in the body's frame, with closed jaws
  Vector3d p_WJ_ = Vector3d::Zero();  // m, gripper's origin in the world
  Stepper stepper_;
};

class GraspTests {
 public:
  explicit GraspTests(const ProbeTest& test)
      : test_(test), m_(test.m), grasping_(*test.checks().grasps), gripper_(test.m) {
    m_.opt.cone = mjCONE_ELLIPTIC;
    m_.opt.impratio = kImpratio;
    engine::EnableMultipleContacts(m_.opt);
    engine::TightenTolerance(m_.opt);
    // Planes do not collide, because the object hangs in the air.
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (m_.geom_type[geom] == mjGEOM_PLANE) m_.geom_contype[geom] = m_.geom_conaffinity[geom] = 0;
    }
  }

  void Check() {
    bool has_sites = !grasping_.sites.empty();
    for (const std::string& site : grasping_.sites) {
      const auto id = FindNamed(test_, mjOBJ_SITE, site, {"grasps", grasping_.mark});
      if (id) TrySite(*id);
    }
    for (int site = 0; site < m_.nsite && grasping_.sites.empty(); ++site) {
      if (!OwnName(m_, mjOBJ_SITE, site, test_.object.name).starts_with(kSitePrefix)) continue;
      has_sites = true;
      TrySite(site);
    }
    if (has_sites) return;
    if (const std::vector<int> bodies = FreeBodies(m_); !bodies.empty())
      return Try("", std::nullopt, [&](const GraspSearch& search, const mjData&) {
        return search.Anywhere(bodies.front());
      });
    test_.reporter.Error(
        Code::kModelBadValue, grasping_.mark,
        fmt::format("`grasps`: '{}' has no free body that could be lifted", test_.object.name),
        "name sites on bodies that have joints");
  }

 private:
  void TrySite(int site) {
    const int body = m_.site_bodyid[site];
    const std::optional<int> joint = JointAbove(m_, body);
    const int root = m_.body_rootid[body];
    const std::string own = OwnName(m_, mjOBJ_SITE, site, test_.object.name);
    if (!joint && !HasFreeJoint(m_, root)) {
      test_.reporter.Error(Code::kModelBadValue, grasping_.mark,
                           fmt::format("`grasps`: what site '{}' is on cannot move", own),
                           "leave that site out, or give the body a joint");
      return;
    }
    Try(own, joint, [&](const GraspSearch& search, const mjData& d) {
      return search.AtSite(SitePose(d, site), joint ? body : root);
    });
  }

  /// Simulates the grasps that `find` returns, and adds an error if no grasp holds the object.
  template <typename Find>
  void Try(const std::string& site, std::optional<int> joint, const Find& find) {
    const engine::Model copy(mj_copyModel(nullptr, &m_));
    if (joint) {
      for (const int body : FreeBodies(m_))
        for (int k = 0; k < 6; ++k) HoldDof(*copy, m_.body_dofadr[body] + k);
    }
    std::vector<GraspCandidate> candidates;
    {
      mjData& d = test_.workspace.For(*copy);
      const GraspSearch search(*copy, d, gripper_, test_.start, grasping_);
      candidates = find(search, d);
    }
    std::vector<GraspOutcome> outcomes;
    for (const GraspCandidate& candidate : candidates) {
      outcomes.push_back(Simulate(*copy, test_.workspace, [&](mjData& d) {
        return GraspSimulation(*copy, d, gripper_, grasping_, joint).Run(candidate, test_.start);
      }));
      Record(site, candidate, outcomes.back());
    }
    if (std::ranges::find(outcomes, GraspOutcome::kHeld) == outcomes.end()) Report(site, outcomes);
  }

  void Record(const std::string& site, const GraspCandidate& candidate, GraspOutcome outcome) {
    mjData& d = test_.workspace.For(m_);
    gripper_.Place(d, test_.start, candidate.X_WJ, 0);
    mj_kinematics(&m_, &d);
    const model::Pose X_BJ =
        compiled::PoseAt(d.xpos, d.xquat, candidate.body).Inverse() * candidate.X_WJ;
    const Eigen::Quaterniond q = X_BJ.q;
    test_.result.grasps.push_back(
        {.site = site,
         .body = OwnName(m_, mjOBJ_BODY, candidate.body, test_.object.name),
         .pos = X_BJ.p,
         .quat = {q.w(), q.x(), q.y(), q.z()},
         .width = candidate.width,
         .held = outcome == GraspOutcome::kHeld});
  }

  void Report(const std::string& site, const std::vector<GraspOutcome>& outcomes) {
    const std::string where = site.empty() ? "" : fmt::format(" at site '{}'", site);
    if (outcomes.empty()) {
      test_.reporter.Error(
          Code::kPhysicsNotGrasped, grasping_.mark,
          fmt::format("'{}' has no two faces{} that jaws of {} mm can close on", test_.object.name,
                      where, RoundedText(1000 * grasping_.width)),
          "a site must be between the faces; there must be room for fingers of "
          "10 x 20 mm, or a wider `width`");
      return;
    }
    const auto count = [&](GraspOutcome outcome) { return std::ranges::count(outcomes, outcome); };
    std::string how;
    const std::pair<GraspOutcome, const char*> words[] = {
        {GraspOutcome::kMissed, "do not close on it"},
        {GraspOutcome::kSlipped, "lose it"},
        {GraspOutcome::kStuck, "do not let go of it"},
        {GraspOutcome::kDiverged, "diverge"}};
    for (const auto& [outcome, word] : words) {
      if (count(outcome) > 0)
        how += fmt::format("{}{} {}", how.empty() ? "" : ", ", count(outcome), word);
    }
    test_.reporter.Error(
        Code::kPhysicsNotGrasped, grasping_.mark,
        fmt::format("jaws that close with {} N do not hold '{}'{}: of {}, {}",
                    RoundedText(grasping_.force), test_.object.name, where,
                    diag::Counted(outcomes.size(), "way"), how),
        "put the site nearer to the centre of mass, where the faces are parallel; if it "
        "slips, make it lighter or set more `force`; if the jaws press into something "
        "light and round, set less `force` or a shorter `solref`");
  }

  const ProbeTest& test_;
  mjModel& m_;
  const model::GraspingCheck& grasping_;
  Gripper gripper_;
};

}  // namespace

void CheckGrasps(const ProbeTest& test) { GraspTests(test).Check(); }

}  // namespace mjforge::physics
