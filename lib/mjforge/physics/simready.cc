// Tests of the SimReady Foundation's benchmark: drops on a floor and on a slope, and results of
// driven joints.
#include "mjforge/physics/model_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using Eigen::Vector3d;
using expr::ExceededLimit;
using expr::RoundedText;
using expr::SpeedText;

// Limits of the benchmark.
constexpr double kDropHeights = 8;   // drop height, as a multiple of the object's height
constexpr double kRestWithin = 8;    // s, longest time to rest after the fall
constexpr double kLeastGravity = 1;  // m/s^2; with less, an object may not reach the floor
constexpr double kFloorDepth = 0.1;  // m, largest depth of the object's bounding box in the floor
constexpr double kExplosion = 10;    // factor by which the object's diagonal may grow
constexpr double kReach = 0.10;      // rad, largest part of a hinge's range that is not reached
constexpr double kReachOfSlide = 0.02;  // share of a slide's range that may not be reached
// Largest distance of a joint from its start after the sweep, rad or m.
constexpr double kReturn = 0.01;
constexpr double kSlope = std::numbers::pi / 4;
// Friction on the slope, which the benchmark does not state: with MuJoCo's default of 1, nothing
// slides on a slope of 45 degrees; 0.5 is the default of PhysX.
constexpr double kSlopeFriction = 0.5;
constexpr double kSlopeTime = 2;    // s
constexpr double kSlides = 2;       // least sliding distance, as a multiple of the object's size
constexpr double kInterval = 0.01;  // s, time between measurements
constexpr double kStill = 0.1;      // s, time for which a resting object must be slow
constexpr const char* kNothingCollides = "none of its geoms collides";
constexpr const char* kPass = "pass";
constexpr const char* kFail = "fail";

/// Reason why a test fails; nullopt if the object passes.
using Problem = std::optional<std::string>;

/// Returns the last plane of the world; nullopt if there is none.
std::optional<int> FloorOf(const mjModel& m) {
  std::optional<int> floor;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (m.geom_type[geom] == mjGEOM_PLANE && m.geom_bodyid[geom] == 0) floor = geom;
  }
  return floor;
}

/// Simulation of an object that falls on a floor or a slope.
class Fall {
 public:
  Fall(mjModel& m, mjData& d, int floor, const model::Checks& checks)
      : m_(m), d_(d), roots_(FreeBodies(m)), checks_(checks), stepper_(m, d) {
    compiled::CopyStart(m, d);
    compiled::UpdatePoses(m, d);
    const mjtNum* mat = d.geom_xmat + 9 * floor;
    normal_ = Vector3d(mat[2], mat[5], mat[8]);
    on_floor_ = compiled::VectorAt(d.geom_xpos, floor);
    size_ = Extent();
  }

  /// Checks that the object comes to rest on the floor without sinking in.
  Problem Drop() {
    if (size_ == 0) return kNothingCollides;
    const model::Box3 box = Box();
    const double height = kDropHeights * (box.max.z() - box.min.z());
    const double fall = std::sqrt(2 * height / std::max(mju_norm3(m_.opt.gravity), kLeastGravity));
    Lift(height);
    double touched = -1;
    double slow_since = -1;
    double lowest = 0;
    for (double t = 0; touched < 0 || t < touched + kRestWithin; t += kInterval) {
      if (Problem problem = Advance()) return problem;
      const bool slow = FindFastestBody(m_, d_).speed < checks_.rest_speed;
      if (touched < 0 && d_.ncon > 0 && Lowest() < kFloorDepth) touched = t;
      if (touched < 0 && t > fall + kRestWithin) return "it does not reach the floor";
      lowest = std::min(lowest, Lowest());
      if (lowest < -kFloorDepth)
        return fmt::format("it gets {} mm into the floor", RoundedText(-1000 * lowest));
      if (!slow) slow_since = -1;
      if (slow && slow_since < 0) slow_since = t;
      if (touched >= 0 && slow && t - slow_since >= kStill) return CheckSink();
    }
    return fmt::format(
        "{:g} s after it touches the floor it still moves, at the end at {}; at rest it is slower "
        "than {} for {:g} s",
        kRestWithin, SpeedText(FindFastestBody(m_, d_).speed), SpeedText(checks_.rest_speed),
        kStill);
  }

  /// Checks that the object slides by kSlides times its size, measured along the slope.
  Problem Slide() {
    if (size_ == 0) return kNothingCollides;
    Lift(DropHeight(m_));
    const std::vector<Vector3d> starts = Centers();
    const Vector3d level = Vector3d(normal_.x(), normal_.y(), 0).normalized();
    const Vector3d downhill = normal_.z() * level - level.dot(normal_) * Vector3d::UnitZ();
    double way = 0;
    for (double t = 0; t < kSlopeTime; t += kInterval) {
      if (Problem problem = Advance()) return problem;
      const std::vector<Vector3d> centers = Centers();
      for (std::size_t i = 0; i < centers.size(); ++i) {
        if ((centers[i] - on_floor_).dot(normal_) < -kFloorDepth)
          return "it goes through the slope";
        way = std::max(way, (centers[i] - starts[i]).dot(downhill));
      }
      if (way > kSlides * size_) return std::nullopt;
    }
    const ExceededLimit beyond(1000 * way, 1000 * kSlides * size_);
    return fmt::format("in {:g} s it slides by {} mm, less than {} mm", kSlopeTime, beyond.value,
                       beyond.limit);
  }

 private:
  Problem CheckSink() const {
    const double sink = DeepestContact(d_);
    if (sink <= checks_.sink) return std::nullopt;
    const ExceededLimit beyond(1000 * sink, 1000 * checks_.sink);
    return fmt::format("it rests {} mm deep, more than {} mm", beyond.value, beyond.limit);
  }

  /// Simulates until the next measurement.
  Problem Advance() {
    const int steps = std::max(1, static_cast<int>(std::lround(kInterval / m_.opt.timestep)));
    for (int i = 0; i < steps; ++i) stepper_.Step();
    compiled::UpdatePoses(m_, d_);
    if (HasDiverged(d_)) return "the simulation diverges";
    if (Explodes()) return "its parts fly apart";
    return std::nullopt;
  }

  model::Box3 Box() const { return CollidingBox(m_, d_, roots_); }

  /// Returns the diagonal, m, of the largest bounding box of a tree of bodies with a free root.
  double Extent() const {
    double extent = 0;
    for (const int root : roots_) {
      const model::Box3 box = compiled::CollidingBox(m_, d_, root);
      if (!box.empty()) extent = std::max(extent, (box.max - box.min).norm());
    }
    return extent;
  }
  bool Explodes() const { return Extent() > kExplosion * size_; }

  /// Returns the distance of the lowest corner of Box() above the plane, m.
  double Lowest() const {
    const model::Box3 box = Box();
    if (box.empty()) return 0;
    const Vector3d lowest = (normal_.array() > 0).select(box.min, box.max);
    return (lowest - on_floor_).dot(normal_);
  }

  void Lift(double height) {
    const double up = (height - Lowest()) / normal_.z();
    for (const int root : roots_) d_.qpos[m_.jnt_qposadr[m_.body_jntadr[root]] + 2] += up;
    compiled::UpdatePoses(m_, d_);
  }

  std::vector<Vector3d> Centers() const {
    return diag::Mapped<Vector3d>(
        roots_, [&](int root) { return compiled::VectorAt(d_.subtree_com, root); });
  }

  mjModel& m_;
  mjData& d_;
  const std::vector<int> roots_;
  const model::Checks& checks_;
  Vector3d normal_ = Vector3d::UnitZ();   // normal of the floor or slope
  Vector3d on_floor_ = Vector3d::Zero();  // m, a point of the floor or slope
  double size_ = 0;                       // m, Extent() at the start
  Stepper stepper_;
};

void MakeSlope(mjModel& m, int floor) {
  const mjtNum quat[] = {std::cos(kSlope / 2), 0, std::sin(kSlope / 2), 0};
  mju_copy4(m.geom_quat + 4 * floor, quat);
  m.geom_sameframe[floor] = 0;
  // Changes all geoms, because the friction of a contact is the larger friction of its two geoms.
  for (int geom = 0; geom < m.ngeom; ++geom)
    m.geom_friction[3 * geom] = std::min(m.geom_friction[3 * geom], kSlopeFriction);
}

class SimReadyTests {
 public:
  explicit SimReadyTests(const ModelTest& test) : test_(test), m_(test.m) {}

  Result::SimReady Check(const DriveResults& drives) {
    Result::SimReady passes;
    const std::optional<int> floor = FloorOf(m_);
    const engine::Model copy(mj_copyModel(nullptr, &m_));
    if (floor && !FreeBodies(m_).empty()) {
      passes.ground_drop = Judge("ground_drop", Run(*copy, *floor, &Fall::Drop));
      MakeSlope(*copy, *floor);
      passes.slope_drop = Judge("slope_drop", Run(*copy, *floor, &Fall::Slide));
    }
    if (drives.joints.empty()) return passes;
    passes.full_range_sweep = Judge("full_range_sweep", Sweep(drives));
    passes.self_collision = Judge("self_collision", Collisions(drives));
    return passes;
  }

 private:
  Problem Run(mjModel& m, int floor, Problem (Fall::*test)()) {
    return Simulate(m, test_.workspace,
                    [&](mjData& d) { return (Fall(m, d, floor, test_.checks()).*test)(); });
  }

  Problem Sweep(const DriveResults& drives) const {
    for (const DrivenJoint& driven : drives.joints) {
      const Result::Joint& joint = driven.measured;
      const bool slides = m_.jnt_type[driven.joint] == mjJNT_SLIDE;
      const double most = slides ? kReachOfSlide * driven.range : kReach;
      const auto more = [&](const char* words, double value, double limit) {
        const ExceededLimit beyond(slides ? 1000 * value : value, slides ? 1000 * limit : limit);
        const char* unit = slides ? "mm" : "rad";
        return fmt::format(fmt::runtime(words), joint.name,
                           fmt::format("{} {}", beyond.value, unit),
                           fmt::format("more than {} {}", beyond.limit, unit));
      };
      const double missing = (1 - joint.reach) * driven.range;
      if (missing > most) return more("joint '{}' lacks {} of its range, {}", missing, most);
      if (joint.overshoot > most)
        return more("joint '{}' goes {} beyond its range, {}", joint.overshoot, most);
      if (joint.return_error > kReturn)
        return more("joint '{}' ends {} from where it began, {}", joint.return_error, kReturn);
    }
    return std::nullopt;
  }

  Problem Collisions(const DriveResults& drives) const {
    const double most = test_.checks().joint_penetration;
    for (const InitialPenetration& initial : drives.initial_penetrations) {
      if (initial.depth > most)
        return fmt::format("bodies '{}' and '{}' are {} mm in each other",
                           test_.BodyName(initial.body1), test_.BodyName(initial.body2),
                           RoundedText(1000 * initial.depth));
    }
    for (const DrivenJoint& driven : drives.joints) {
      if (driven.measured.penetration > most)
        return fmt::format("joint '{}' pushes bodies '{}' and '{}' {} mm into each other",
                           driven.measured.name, driven.body1, driven.body2,
                           RoundedText(1000 * driven.measured.penetration));
    }
    return std::nullopt;
  }

  /// Adds an error if there is a problem; returns "pass" or "fail" for result.simready.
  std::string Judge(std::string_view test, const Problem& problem) {
    if (!problem) return kPass;
    test_.reporter.Error(diag::Code::kPhysicsSimReady, test_.mark,
                         fmt::format("'{}' fails {}: {}", test_.object.name, test, *problem),
                         "docs/physics.md says what the SimReady benchmark asks for");
    return kFail;
  }

  const ModelTest& test_;
  const mjModel& m_;
};

}  // namespace

void CheckSimReady(const ModelTest& test, const DriveResults& drives) {
  test.result.simready = SimReadyTests(test).Check(drives);
}

}  // namespace mjforge::physics
