#include "mjforge/physics/grasping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/added.h"
#include "mjforge/physics/grasp_search.h"
#include "mjforge/physics/jaws.h"
#include "mjforge/physics/named.h"
#include "mjforge/physics/rounding.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using Eigen::Vector3d;

// In the jaws' own frame, which is accelerated in place of being moved.
constexpr double kClose = 0.5;      // s
constexpr double kBounce = 0.1;     // s, for which jaws may leave what pushes them back
constexpr double kGiving = 0.02;    // m/s
constexpr double kArm = 0.05;       // m
constexpr double kLift = 0.3;       // s
constexpr double kShake = 0.2;      // s along each axis
constexpr double kHold = 2;         // s
constexpr double kOpen = 0.3;       // s
constexpr double kLifting = 1.5;    // of gravity
constexpr double kShaking = 0.5;    // of gravity
constexpr double kFrequency = 5;    // Hz
constexpr double kMostSlip = 0.02;  // m: the jaws' faces are as large
// What has been as slow for as long under a steady load does not slip by 2 mm in the rest of kHold.
constexpr double kStillSpeed = 0.001;  // m/s
constexpr double kStillTime = 0.2;     // s
constexpr double kImpratio = 10;       // friction that does not creep
constexpr std::string_view kSitePrefix = "grasp";

/// What became of a try.
enum class Grip { kHeld, kMissed, kSlipped, kStuck, kDiverged };

/// Lets free bodies move as slowly as on a table where jaws push them, as long as it lives: by
/// kGiving m/s for as much force as the jaws have, and turn by as much at kArm.
class SlowRoots {
 public:
  SlowRoots(mjModel& m, double force) : m_(m), damping_(m.dof_damping, m.dof_damping + m.nv) {
    for (int joint = 0; joint < m.njnt; ++joint) {
      if (m.jnt_type[joint] != mjJNT_FREE) continue;
      for (int k = 0; k < 6; ++k)
        m.dof_damping[m.jnt_dofadr[joint] + k] = force / kGiving * (k < 3 ? 1 : kArm * kArm);
    }
  }
  ~SlowRoots() { std::ranges::copy(damping_, m_.dof_damping); }
  SlowRoots(const SlowRoots&) = delete;
  SlowRoots& operator=(const SlowRoots&) = delete;

 private:
  mjModel& m_;
  std::vector<mjtNum> damping_;
};

/// A hinge or slide that moves what the jaws are to hold; -1: none, so that it is lifted.
int JointUnder(const mjModel& m, int body) {
  for (; body > 0; body = m.body_parentid[body]) {
    for (int i = 0; i < m.body_jntnum[body]; ++i) {
      const int joint = m.body_jntadr[body] + i;
      if (compiled::HasOneNumber(m, joint)) return joint;
    }
  }
  return -1;
}

bool IsFree(const mjModel& m, int root) {
  return m.body_jntnum[root] == 1 && m.jnt_type[m.body_jntadr[root]] == mjJNT_FREE;
}

class Attempt {
 public:
  Attempt(mjModel& m, mjData& d, const Jaws& jaws, const model::Grasping& grasping, int joint)
      : m_(m), d_(d), jaws_(jaws), grasping_(grasping), joint_(joint), stepper_(m, d) {}

  Grip Run(const Candidate& candidate, std::span<const mjtNum> start) {
    jaws_.Place(d_, start, candidate.X_WJ, OpeningFor(candidate, grasping_));
    body_ = candidate.body;
    mj_kinematics(&m_, &d_);
    p_WJ_ = candidate.X_WJ.p;
    std::optional<SlowRoots> slow(std::in_place, m_, grasping_.force);
    jaws_.Press(d_, grasping_.force);
    Gravity().setZero();
    if (!Pass(kClose)) return Grip::kDiverged;
    if (!Touches()) return Grip::kMissed;
    p_BJ_ = BodyPose().Inverse() * p_WJ_;
    slow.reset();
    const Grip grip = joint_ < 0 ? Lift() : Pull();
    if (grip != Grip::kHeld) return grip;
    jaws_.Press(d_, -grasping_.force);
    if (!Pass(kOpen)) return Grip::kDiverged;
    return apart_ == 0 ? Grip::kStuck : Grip::kHeld;
  }

 private:
  model::Pose BodyPose() const { return compiled::PoseAt(d_.xpos, d_.xquat, body_); }
  double Slip() const { return (BodyPose() * p_BJ_ - p_WJ_).norm(); }

  Eigen::Map<Vector3d> Gravity() { return Eigen::Map<Vector3d>(m_.opt.gravity); }

  /// False: the simulation diverges.
  bool Step() {
    stepper_.Step();
    apart_ = jaws_.Hold(d_, m_.body_rootid[body_]) ? 0 : apart_ + m_.opt.timestep;
    still_ = FastestPoint(m_, d_).speed < kStillSpeed ? still_ + m_.opt.timestep : 0;
    return !HasBlownUp(d_);
  }

  bool Pass(double time) {
    for (double t = 0; t < time; t += m_.opt.timestep) {
      if (!Step()) return false;
    }
    return true;
  }

  /// Of all that moves, under a load that has been the same all the while.
  bool IsStill() const { return still_ >= kStillTime; }

  bool Touches() const { return apart_ < kBounce; }
  bool Holds() const { return Touches() && Slip() <= kMostSlip; }

  Grip Lift() {
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
      if (!Step()) return Grip::kDiverged;
      if (Slip() > kMostSlip) return Grip::kSlipped;
    }
    return Holds() ? Grip::kHeld : Grip::kSlipped;
  }

  /// Both ways along the joint.
  Grip Pull() {
    Gravity() = Vector3d(0, 0, -kEarthGravity);
    const int dof = m_.jnt_dofadr[joint_];
    const Vector3d axis = compiled::VectorAt(d_.xaxis, joint_);
    const Vector3d arm = p_WJ_ - compiled::VectorAt(d_.xanchor, joint_);
    const double lever = m_.jnt_type[joint_] == mjJNT_HINGE ? axis.cross(arm).norm() : axis.norm();
    for (const double way : {1.0, -1.0}) {
      d_.qfrc_applied[dof] = way * grasping_.pull * lever;
      still_ = 0;
      for (double t = 0; t < kHold / 2 && !IsStill(); t += m_.opt.timestep) {
        if (!Step()) return Grip::kDiverged;
        if (Slip() > kMostSlip) return Grip::kSlipped;
      }
    }
    d_.qfrc_applied[dof] = 0;
    return Holds() ? Grip::kHeld : Grip::kSlipped;
  }

  mjModel& m_;
  mjData& d_;
  const Jaws& jaws_;
  const model::Grasping& grasping_;
  int joint_;
  int body_ = 0;
  double apart_ = 0;                  // s, for how long the jaws have not touched it
  double still_ = 0;                  // s, for how long all has been as slow as kStillSpeed
  Vector3d p_BJ_ = Vector3d::Zero();  // the middle between the jaws, in the body
  Vector3d p_WJ_ = Vector3d::Zero();
  Stepper stepper_;
};

class Grasps {
 public:
  Grasps(mjModel& m, Workspace& workspace, std::span<const mjtNum> start, const std::string& name,
         Verdict& verdict, std::vector<Result::Grasp>& results)
      : m_(m),
        workspace_(workspace),
        start_(start),
        name_(name),
        verdict_(verdict),
        grasping_(*verdict.checks().grasps),
        jaws_(m),
        results_(results) {
    m.opt.cone = mjCONE_ELLIPTIC;
    m.opt.impratio = kImpratio;
    engine::EnableMultipleContacts(m.opt);
    engine::TightenTolerance(m.opt);
    for (int geom = 0; geom < m.ngeom; ++geom) {  // it hangs in the air
      if (m.geom_type[geom] == mjGEOM_PLANE) m.geom_contype[geom] = m.geom_conaffinity[geom] = 0;
    }
  }

  void Check() {
    bool has_sites = !grasping_.sites.empty();
    for (const std::string& site : grasping_.sites) {
      const int id = FindNamed(m_, mjOBJ_SITE, name_, site, {"grasps", grasping_.mark}, verdict_);
      if (id >= 0) TrySite(id);
    }
    for (int site = 0; site < m_.nsite && grasping_.sites.empty(); ++site) {
      if (!OwnName(m_, mjOBJ_SITE, site, name_).starts_with(kSitePrefix)) continue;
      has_sites = true;
      TrySite(site);
    }
    if (has_sites) return;
    for (int body = 1; body < m_.nbody; ++body) {
      if (m_.body_rootid[body] == body && IsFree(m_, body)) return TryBody(body);
    }
    verdict_.Error(Code::kModelBadValue, grasping_.mark,
                   fmt::format("`grasps`: '{}' has no free body that could be lifted", name_),
                   "name sites on bodies that have joints");
  }

 private:
  void TrySite(int site) {
    const int body = m_.site_bodyid[site];
    const int joint = JointUnder(m_, body);
    const int root = m_.body_rootid[body];
    const std::string own = OwnName(m_, mjOBJ_SITE, site, name_);
    if (joint < 0 && !IsFree(m_, root)) {
      verdict_.Error(Code::kModelBadValue, grasping_.mark,
                     fmt::format("`grasps`: what site '{}' is on cannot move", own),
                     "leave that site out, or give the body a joint");
      return;
    }
    Try(own, joint, [&](const GraspSearch& search, const mjData& d) {
      return search.At(SitePose(d, site), joint < 0 ? root : body);
    });
  }

  void TryBody(int root) {
    Try("", -1, [&](const GraspSearch& search, const mjData&) { return search.On(root); });
  }

  template <typename Find>
  void Try(const std::string& site, int joint, const Find& find) {
    const engine::Model copy(mj_copyModel(nullptr, &m_));
    for (int i = 0; i < copy->njnt && joint >= 0; ++i) {
      if (copy->jnt_type[i] != mjJNT_FREE) continue;
      for (int k = 0; k < 6; ++k) HoldDof(*copy, copy->jnt_dofadr[i] + k);
    }
    std::vector<Candidate> candidates;
    {
      mjData& d = workspace_.For(*copy);
      const GraspSearch search(*copy, d, jaws_, start_, grasping_);
      candidates = find(search, d);
    }
    std::vector<Grip> outcomes;
    for (const Candidate& candidate : candidates) {
      outcomes.push_back(Simulate(*copy, candidate, joint));
      Record(site, candidate, outcomes.back());
    }
    if (std::ranges::find(outcomes, Grip::kHeld) == outcomes.end()) Report(site, outcomes);
  }

  Grip Simulate(mjModel& m, const Candidate& candidate, int joint) {
    for (;;) {
      mjData& d = workspace_.For(m);
      const Grip grip = Attempt(m, d, jaws_, grasping_, joint).Run(candidate, start_);
      if (!MakeRoom(m, d)) return grip;
    }
  }

  void Record(const std::string& site, const Candidate& candidate, Grip outcome) {
    mjData& d = workspace_.For(m_);
    jaws_.Place(d, start_, candidate.X_WJ, 0);
    mj_kinematics(&m_, &d);
    const model::Pose X_BJ =
        compiled::PoseAt(d.xpos, d.xquat, candidate.body).Inverse() * candidate.X_WJ;
    const Eigen::Quaterniond q = X_BJ.q;
    results_.push_back({.site = site,
                        .body = OwnName(m_, mjOBJ_BODY, candidate.body, name_),
                        .pos = X_BJ.p,
                        .quat = {q.w(), q.x(), q.y(), q.z()},
                        .width = candidate.width,
                        .held = outcome == Grip::kHeld});
  }

  void Report(const std::string& site, const std::vector<Grip>& outcomes) {
    const std::string where = site.empty() ? "" : fmt::format(" at site '{}'", site);
    if (outcomes.empty()) {
      verdict_.Error(Code::kPhysicsNotGrasped, grasping_.mark,
                     fmt::format("'{}' has no two faces{} that jaws of {} mm can close on", name_,
                                 where, RoundedText(1000 * grasping_.width)),
                     "a site must be between the faces; there must be room for fingers of "
                     "10 x 20 mm, or a wider `width`");
      return;
    }
    const auto count = [&](Grip outcome) { return std::ranges::count(outcomes, outcome); };
    std::string how;
    const std::pair<Grip, const char*> words[] = {{Grip::kMissed, "do not close on it"},
                                                  {Grip::kSlipped, "lose it"},
                                                  {Grip::kStuck, "do not let go of it"},
                                                  {Grip::kDiverged, "diverge"}};
    for (const auto& [outcome, word] : words) {
      if (count(outcome) > 0)
        how += fmt::format("{}{} {}", how.empty() ? "" : ", ", count(outcome), word);
    }
    verdict_.Error(Code::kPhysicsNotGrasped, grasping_.mark,
                   fmt::format("jaws that close with {} N do not hold '{}'{}: of {} {}, {}",
                               RoundedText(grasping_.force), name_, where, outcomes.size(),
                               outcomes.size() == 1 ? "way" : "ways", how),
                   "put the site nearer to the centre of mass, where the faces are parallel; if it "
                   "slips, make it lighter or set more `force`; if the jaws press into something "
                   "light and round, set less `force` or a shorter `solref`");
  }

  mjModel& m_;
  Workspace& workspace_;
  std::span<const mjtNum> start_;
  const std::string& name_;
  Verdict& verdict_;
  const model::Grasping& grasping_;
  Jaws jaws_;
  std::vector<Result::Grasp>& results_;
};

}  // namespace

void CheckGrasping(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                   const std::string& name, Verdict& verdict, Result& result) {
  Grasps(m, workspace, start, name, verdict, result.grasps).Check();
}

}  // namespace mjforge::physics
