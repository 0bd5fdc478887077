// Simulates the drop of a model and its driven joints, and reports values beyond the limits of the
// checks.
#include "mjforge/physics/behaviour.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/physics/causes.h"
#include "mjforge/physics/drop.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/joint_rest.h"
#include "mjforge/physics/model_checks.h"
#include "mjforge/physics/stability.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using expr::ExceededLimit;
using expr::RoundedText;
using expr::SpeedText;

constexpr const char* kHarderContacts = "use harder contacts: a smaller solref, solimp closer to 1";
constexpr const char* kMakeRoom = "make room, use another `pose`, or add `contact: exclude`";
constexpr const char* kInTheWay = "use a shorter range, make room, or add `contact: exclude`";

constexpr double kDegrees = 180 / std::numbers::pi;

// Limits of the timestep. MuJoCo accepts any timestep, but the drop test is useless if a step is
// longer than the fall.
constexpr double kShortestStep = 1e-5;  // s
constexpr double kLongestStep = 0.02;   // s; a fall of 2 mm takes 0.02 s

class Behaviour {
 public:
  explicit Behaviour(const ModelTest& test) : test_(test), m_(test.m) {}

  /// Records the drop and, if a nudge (an initial tilt and speed) topples the object, the drop with
  /// that nudge.
  void RecordDrop(FilmRecorder& recorder) {
    if (!CanStep()) return;
    recorder_ = &recorder;
    Drop({}, test_.result);
    recorder.Keep();
    CheckStability(test_.result);
  }

  void Check() {
    const std::string& object = test_.object.name;
    const model::Checks& checks = test_.checks();
    if (!CanStep() || !JointChecks(m_, object, checks).Verify(test_.reporter)) return;
    Result& result = test_.result;
    const DropOutcome outcome = Drop({}, result);
    if (outcome.has_diverged) return ReportDivergence(outcome);
    for (const std::string& warning : outcome.warnings) {
      test_.reporter.Error(Code::kPhysicsUnstable, test_.mark,
                           fmt::format("MuJoCo warns as '{}' settles: {}", object, warning));
    }
    ReportDrop(outcome, result);
    CheckJointRests(test_, *end_);
    const std::vector<mjtNum> rest(end_->qpos, end_->qpos + m_.nq);
    CheckStability(result);
    CheckRestsInside(test_, rest);
    CheckRanges(test_);
    CheckEfforts(test_);
    CheckUnsupportedLinks(test_);
    const DriveResults drives = DriveJoints(m_, test_.workspace.For(m_), object, checks);
    for (const InitialPenetration& initial : drives.initial_penetrations)
      ReportInitialPenetration(initial);
    CheckParents(test_);
    for (const DrivenJoint& driven : drives.joints) {
      result.joints.push_back(driven.measured);
      ReportJoint(driven);
    }
    CheckEqualities(test_);
    if (checks.simready) CheckSimReady(test_, drives);
  }

 private:
  bool CanStep() {
    const double timestep = m_.opt.timestep;
    const double time = test_.checks().settle_time;
    if (timestep >= kShortestStep && timestep <= kLongestStep && time / timestep <= kMostSteps) {
      return true;
    }
    test_.reporter.Error(
        Code::kPhysicsUnstable, test_.mark,
        fmt::format("'{}' cannot be simulated: {:g} s in steps of {:g} s", test_.object.name, time,
                    timestep),
        fmt::format("use a timestep of {:g} to {:g} s and a settle_time of at most {:g} steps",
                    kShortestStep, kLongestStep, kMostSteps));
    return false;
  }

  DropOutcome Drop(const Nudge& nudge, Result& result) {
    return Simulate(m_, test_.workspace, [&](mjData& d) {
      result = {};  // discards a run whose contacts exceeded the buffers; Simulate() repeats it
      end_ = &d;
      if (recorder_ != nullptr) recorder_->Begin();
      return SimulateDrop(m_, d, test_.checks(), nudge, result, recorder_);
    });
  }

  void ReportDivergence(const DropOutcome& outcome) {
    Divergence found = FindDivergence(m_, *end_, test_.workspace);
    const diag::SourceMark mark = found.actuator.empty()
                                      ? test_.JointMark(found.joint)
                                      : test_.ElementMark("actuator", found.actuator);
    test_.reporter.Error(
        Code::kPhysicsUnstable, mark,
        fmt::format("the simulation diverges as '{}' settles: {} (MuJoCo: {})", test_.object.name,
                    found.cause, fmt::join(outcome.warnings, " ")),
        std::move(found.hint));
  }

  void CheckStability(Result& result) {
    if (!result.dropped || !result.at_rest || result.ncon == 0) return;
    const std::optional<int> body = FreeStandingBody(m_, *end_);
    if (!body) return;
    const StabilityMargin margin = FindStabilityMargin(m_, *end_, *body, result.sink);
    result.stability = margin.least;
    const model::Checks& checks = test_.checks();
    if (!checks.stable || result.tilt > checks.tilt) return;
    CheckFeet(test_, *end_, *body, GroundOf(m_, *end_).height);
    const double gravity = Eigen::Map<const Eigen::Vector3d>(m_.opt.gravity).norm();
    const double height =
        end_->subtree_com[3 * *body + 2] - compiled::CollidingBox(m_, *end_, *body).min.z();
    // Speed of an inverted pendulum of this height, m/s, after a fall from upright to a tilt of
    // checks.nudge (for small angles).
    const double speed = checks.nudge * std::sqrt(gravity * std::max(height, 0.0));
    std::vector<Nudge> nudges = {{.speed = speed, .azimuth = margin.azimuth}};
    for (int side = 0; side < 4; ++side)
      nudges.push_back(
          {.tilt = checks.nudge, .azimuth = margin.azimuth + side * std::numbers::pi / 2});
    for (const Nudge& nudge : nudges) {
      Result nudged;
      const DropOutcome outcome = Drop(nudge, nudged);
      if (!outcome.has_diverged && nudged.tilt <= checks.tilt) continue;
      ReportToppling(nudge, margin, nudged);
      if (recorder_ != nullptr) recorder_->Keep();
      return;
    }
  }

  void ReportToppling(const Nudge& nudge, const StabilityMargin& margin, const Result& nudged) {
    const std::string how =
        nudge.tilt > 0 ? fmt::format("tilted by {} deg", RoundedText(kDegrees * nudge.tilt))
                       : fmt::format("pushed at {} m/s", RoundedText(nudge.speed));
    test_.reporter.Error(
        Code::kPhysicsTopples, test_.mark,
        fmt::format("'{}' topples when it is {}: it leans over by {} deg{}; at rest it "
                    "can be tilted by {} deg ({:.2g} J)",
                    test_.object.name, how, RoundedText(kDegrees * nudged.tilt),
                    MovedJointText(m_, *end_), RoundedText(kDegrees * margin.least.angle),
                    margin.least.energy),
        "give it a wider foot or a lower centre of mass, or set `nudge`");
  }

  void ReportInitialPenetration(const InitialPenetration& initial) {
    if (!(initial.depth > test_.checks().joint_penetration)) return;
    test_.reporter.Error(
        Code::kPhysicsJointCollides, initial.check != nullptr ? initial.check->mark : test_.mark,
        fmt::format("bodies '{}' and '{}' are {} mm in each other before any joint is driven",
                    test_.BodyName(initial.body1), test_.BodyName(initial.body2),
                    RoundedText(1000 * initial.depth)),
        initial.check != nullptr ? "the positions of `at` put them there" : kMakeRoom);
  }

  /// Adds an error if `value` is above `limit`. `text` has the placeholders {0} (the name of the
  /// object), {1} and {2} (value and limit, multiplied by `scale`), and {3} (`along`: ", as joint
  /// 'lid' moves by 90 deg").
  void ReportAbove(Code code, double value, double limit, double scale, const char* text,
                   std::string hint, const std::string& along = {}) {
    if (!(value > limit)) return;
    const ExceededLimit beyond(scale * value, scale * limit);
    test_.reporter.Error(
        code, test_.mark,
        fmt::format(fmt::runtime(text), test_.object.name, beyond.value, beyond.limit, along),
        std::move(hint));
  }

  void ReportDrop(const DropOutcome& outcome, const Result& result) {
    const model::Checks& checks = test_.checks();
    ReportAbove(Code::kPhysicsGainsEnergy, result.energy_gain, checks.energy_gain, 1,
                "'{0}' gains energy as it settles: {1} of mass * gravity * size, more than {2}",
                EnergySourcesHint(m_));
    if (result.dropped && result.ncon == 0) {
      test_.reporter.Warning(
          Code::kPhysicsNotAtRest, test_.mark,
          fmt::format("'{}' touches nothing for {} s and ends at {}", test_.object.name,
                      RoundedText(result.time), SpeedText(result.speed)),
          "check gravity and the contact bits (contype, conaffinity)");
    } else if (!result.at_rest && (result.dropped || HasRestRanges(checks))) {
      test_.reporter.Warning(
          Code::kPhysicsNotAtRest, test_.mark,
          fmt::format("'{}' still moves after {} s: body '{}' at {}, {} mm from where it began; at "
                      "rest it is slower than {} for 0.1 s",
                      test_.object.name, RoundedText(result.time), outcome.fastest,
                      SpeedText(result.speed), RoundedText(1000 * outcome.displacement),
                      SpeedText(checks.rest_speed)),
          RestRemedy(outcome));
    }
    ReportAbove(Code::kPhysicsPenetrates, result.penetration, checks.penetration, 1000,
                "contacts get {1} mm deep as '{0}' lands, more than {2} mm", kHarderContacts);
    ReportAbove(Code::kPhysicsSinks, result.sink, checks.sink, 1000,
                "contacts are {1} mm deep when '{0}' has settled, more than {2} mm",
                kHarderContacts);
    if (checks.stable) {
      ReportAbove(Code::kPhysicsTopples, result.tilt, checks.tilt, kDegrees,
                  "'{0}' topples: it leans over by {1} deg, more than {2} deg{3}",
                  "give it a wider foot or a lower centre of mass", MovedJointText(m_, *end_));
    }
    ReportAbove(Code::kPhysicsDrifts, result.drift, checks.drift, 1000,
                "'{0}' moves {1} mm along the floor, more than {2} mm",
                "give it a level foot or more friction");
  }

  /// Returns the remedy for an object that still moves at the end of checks.settle_time.
  std::string RestRemedy(const DropOutcome& outcome) const {
    const int body = mj_name2id(&m_, mjOBJ_BODY, outcome.fastest.c_str());
    for (int i = 0; body > 0 && i < m_.body_jntnum[body]; ++i) {
      const int joint = m_.body_jntadr[body] + i;
      std::string creep =
          compiled::HasOneNumber(m_, joint) ? CreepRemedy(m_, *end_, joint) : std::string();
      if (!creep.empty()) return creep;
    }
    return "look for an undamped joint or a part that rolls, or set a longer `settle_time`";
  }

  void ReportJoint(const DrivenJoint& driven) {
    const Result::Joint& joint = driven.measured;
    if (driven.has_diverged) {
      ErrorOf(joint, Code::kPhysicsUnstable,
              fmt::format("the simulation diverges as joint '{}' is driven", joint.name),
              "use larger masses or an `armature` for what it moves, softer contacts and "
              "equalities, or a smaller timestep");
      return;
    }
    ReportLimits(driven);
    ReportObstacles(driven);
    const double most =
        Limit(driven, &model::JointCheck::joint_return, test_.checks().joint_return);
    if (joint.return_error > most * driven.range) {
      ErrorOf(joint, Code::kPhysicsJointNotBack,
              fmt::format("joint '{}' does not come back: it ends {} from where it started",
                          joint.name, test_.Distance(driven.joint, joint.return_error)));
    }
  }

  /// Returns the limit `own` of the joint's entry in checks.joints; `usual` if the joint has no
  /// entry or the entry does not set this limit.
  static double Limit(const DrivenJoint& driven, std::optional<double> model::JointCheck::*own,
                      double usual) {
    return driven.check != nullptr ? (driven.check->*own).value_or(usual) : usual;
  }

  void ReportLimits(const DrivenJoint& driven) {
    const Result::Joint& joint = driven.measured;
    const double most =
        driven.range * Limit(driven, &model::JointCheck::overshoot, test_.checks().joint_overshoot);
    const std::string range = test_.Distance(driven.joint, driven.range);
    if (driven.outside > most) {
      ErrorOf(joint, Code::kPhysicsJointOvershoots,
              fmt::format("joint '{}' begins {} outside its range of {}", joint.name,
                          test_.Distance(driven.joint, driven.outside), range),
              "use a range that contains zero, or a pose (`ref`) within the range");
    } else if (joint.overshoot > most) {
      ErrorOf(joint, Code::kPhysicsJointOvershoots,
              fmt::format("joint '{}' goes {} beyond its range of {}", joint.name,
                          test_.Distance(driven.joint, joint.overshoot), range),
              LimitHint(m_, driven.joint, joint.overshoot,
                        "use a harder limit: a smaller solreflimit, solimplimit closer to 1"));
    }
  }

  void ReportObstacles(const DrivenJoint& driven) {
    const model::Checks& checks = test_.checks();
    const Result::Joint& joint = driven.measured;
    if (joint.penetration >
        Limit(driven, &model::JointCheck::penetration, checks.joint_penetration)) {
      ErrorOf(
          joint, Code::kPhysicsJointCollides,
          fmt::format("driving joint '{}' pushes bodies '{}' and '{}' {} mm into each other, at {}",
                      joint.name, driven.body1, driven.body2, RoundedText(1000 * joint.penetration),
                      test_.Distance(driven.joint, driven.where)),
          InTheWayHint(driven, {driven.body1, driven.body2}));
    }
    if (!(joint.reach < Limit(driven, &model::JointCheck::reach, checks.joint_reach))) return;
    const auto pair = driven.free_depth > joint.penetration ? driven.free_pair
                                                            : std::pair(driven.body1, driven.body2);
    const bool collide = !pair.first.empty();
    ErrorOf(
        joint, Code::kPhysicsJointBlocked,
        fmt::format("joint '{}' reaches only {} % of its range of {}", joint.name,
                    RoundedText(100 * joint.reach), test_.Distance(driven.joint, driven.range)) +
            (collide ? fmt::format(": '{}' and '{}' collide", pair.first, pair.second) : ""),
        collide ? InTheWayHint(driven, pair) : HeldBackHint(m_, driven.joint));
  }

  /// Returns the hint for two bodies that collide while a joint is driven.
  std::string InTheWayHint(const DrivenJoint& driven,
                           const std::pair<std::string, std::string>& bodies) const {
    const auto id = [this](const std::string& name) {
      return std::max(mj_name2id(&m_, mjOBJ_BODY, name.c_str()), 0);
    };
    const bool has_pose = driven.check != nullptr && !driven.check->positions.empty();
    if (has_pose || !CanOtherJointSeparate(m_, driven.joint, {id(bodies.first), id(bodies.second)}))
      return kInTheWay;
    return std::string(kInTheWay) +
           "; `at` in `checks: joints:` says where other joints stand meanwhile";
  }

  void ErrorOf(const Result::Joint& joint, Code code, std::string message, std::string hint = {}) {
    test_.reporter.Error(code, test_.JointMark(joint.name), std::move(message), std::move(hint));
  }

  const ModelTest& test_;
  mjModel& m_;
  mjData* end_ = nullptr;  // state at the end of the last drop
  FilmRecorder* recorder_ = nullptr;
};

}  // namespace

void RecordDrop(const ModelTest& test, FilmRecorder& recorder) {
  Behaviour(test).RecordDrop(recorder);
}

void CheckBehaviour(const ModelTest& test) { Behaviour(test).Check(); }

}  // namespace mjforge::physics
