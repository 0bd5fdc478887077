#include "mjforge/physics/simready.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/rounding.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using Eigen::Vector3d;

// The benchmark's.
constexpr double kDropHeights = 8;      // of the object
constexpr double kRestWithin = 8;       // s after it touches the floor
constexpr double kFloorDepth = 0.1;     // m, of its box in the floor
constexpr double kExplosion = 10;       // of its box
constexpr double kReach = 0.10;         // rad, from either end
constexpr double kReachOfSlide = 0.02;  // of its range
constexpr double kReturn = 0.01;        // rad or m
constexpr double kSlope = std::numbers::pi / 4;
// Not said there. With friction 1, MuJoCo's, nothing slides on such a slope; 0.5 is PhysX's.
constexpr double kSlopeFriction = 0.5;
constexpr double kSlopeTime = 2;  // s
constexpr double kSlides = 2;     // of its size
constexpr double kLook = 0.01;    // s
constexpr double kStill = 0.1;    // s, that it is slow
constexpr const char* kPass = "pass";
constexpr const char* kFail = "fail";

/// The plane that it falls on, and what falls.
struct Scene {
  int floor = -1;
  std::vector<int> roots;
};

Scene SceneOf(const mjModel& m) {
  Scene scene;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    if (m.geom_type[geom] == mjGEOM_PLANE && m.geom_bodyid[geom] == 0) scene.floor = geom;
  }
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (m.jnt_type[joint] == mjJNT_FREE) scene.roots.push_back(m.jnt_bodyid[joint]);
  }
  return scene;
}

class Fall {
 public:
  Fall(mjModel& m, mjData& d, const Scene& scene, const model::Checks& checks)
      : m_(m), d_(d), scene_(scene), checks_(checks), stepper_(m, d) {
    std::ranges::copy(compiled::StartOf(m), d.qpos);
    mj_kinematics(&m, &d);
    mj_comPos(&m, &d);
    const mjtNum* mat = d.geom_xmat + 9 * scene.floor;
    normal_ = Vector3d(mat[2], mat[5], mat[8]);
    on_floor_ = compiled::VectorAt(d.geom_xpos, scene.floor);
    size_ = Extent();
  }

  /// What is wrong; empty: nothing.
  std::string Drop() {
    const model::Box3 box = Box();
    Lift(kDropHeights * (box.max.z() - box.min.z()));
    double touched = -1;
    double slow_since = -1;
    double lowest = 0;
    for (double t = 0; touched < 0 || t < touched + kRestWithin; t += kLook) {
      Step(kLook);
      if (HasBlownUp(d_)) return "the simulation diverges";
      if (Explodes()) return "its parts fly apart";
      const bool slow = FastestPoint(m_, d_).speed < checks_.rest_speed;
      if (touched < 0 && d_.ncon > 0 && Lowest() < kFloorDepth) touched = t;
      if (touched < 0 && t > kRestWithin) return "it does not reach the floor";
      lowest = std::min(lowest, Lowest());
      if (lowest < -kFloorDepth)
        return fmt::format("it gets {} mm into the floor", RoundedText(-1000 * lowest));
      if (!slow) slow_since = -1;
      if (slow && slow_since < 0) slow_since = t;
      if (touched >= 0 && slow && t - slow_since >= kStill) return Rested();
    }
    return fmt::format(
        "{:g} s after it touches the floor it still moves, at the end at {}; at rest it is slower "
        "than {} for {:g} s",
        kRestWithin, SpeedText(FastestPoint(m_, d_).speed), SpeedText(checks_.rest_speed), kStill);
  }

  /// Down a slope, by kSlides of its size.
  std::string Slide() {
    Lift(DropHeight(m_));
    const std::vector<Vector3d> starts = Centers();
    const Vector3d downhill = Vector3d(normal_.x(), normal_.y(), 0).normalized();
    double way = 0;
    for (double t = 0; t < kSlopeTime; t += kLook) {
      Step(kLook);
      if (HasBlownUp(d_)) return "the simulation diverges";
      if (Explodes()) return "its parts fly apart";
      const std::vector<Vector3d> centers = Centers();
      for (std::size_t i = 0; i < centers.size(); ++i) {
        if ((centers[i] - on_floor_).dot(normal_) < -kFloorDepth)
          return "it goes through the slope";
        way = std::max(way, (centers[i] - starts[i]).dot(downhill));
      }
      if (way > kSlides * size_) return "";
    }
    const Beyond beyond(1000 * way, 1000 * kSlides * size_);
    return fmt::format("in {:g} s it slides by {} mm, less than {} mm", kSlopeTime, beyond.value,
                       beyond.limit);
  }

 private:
  std::string Rested() const {
    const double sink = DeepestContact(d_);
    if (sink <= checks_.sink) return "";
    const Beyond beyond(1000 * sink, 1000 * checks_.sink);
    return fmt::format("it rests {} mm deep, more than {} mm", beyond.value, beyond.limit);
  }

  void Step(double time) {
    const int steps = std::max(1, static_cast<int>(std::lround(time / m_.opt.timestep)));
    for (int i = 0; i < steps; ++i) stepper_.Step();
    mj_kinematics(&m_, &d_);
    mj_comPos(&m_, &d_);
  }

  model::Box3 Box() const {
    model::Box3 all;
    for (const int root : scene_.roots) {
      const model::Box3 box = compiled::CollidingBox(m_, d_, root);
      if (!box.empty()) all.Add(box);
    }
    return all;
  }

  /// Of the largest of the bodies that are free.
  double Extent() const {
    double extent = 0;
    for (const int root : scene_.roots) {
      const model::Box3 box = compiled::CollidingBox(m_, d_, root);
      if (!box.empty()) extent = std::max(extent, (box.max - box.min).norm());
    }
    return extent;
  }
  bool Explodes() const { return Extent() > kExplosion * size_; }

  /// The lowest corner of the box over the plane, m.
  double Lowest() const {
    const model::Box3 box = Box();
    if (box.empty()) return 0;
    const Vector3d lowest = (normal_.array() > 0).select(box.min, box.max);
    return (lowest - on_floor_).dot(normal_);
  }

  void Lift(double height) {
    const double up = (height - Lowest()) / normal_.z();
    for (const int root : scene_.roots) d_.qpos[m_.jnt_qposadr[m_.body_jntadr[root]] + 2] += up;
    mj_kinematics(&m_, &d_);
    mj_comPos(&m_, &d_);
  }

  std::vector<Vector3d> Centers() const {
    std::vector<Vector3d> centers;
    centers.reserve(scene_.roots.size());
    for (const int root : scene_.roots)
      centers.emplace_back(compiled::VectorAt(d_.subtree_com, root));
    return centers;
  }

  mjModel& m_;
  mjData& d_;
  const Scene& scene_;
  const model::Checks& checks_;
  Vector3d normal_ = Vector3d::UnitZ();
  Vector3d on_floor_ = Vector3d::Zero();
  double size_ = 0;  // m
  Stepper stepper_;
};

void Tilt(mjModel& m, int floor) {
  const mjtNum quat[] = {std::cos(kSlope / 2), 0, std::sin(kSlope / 2), 0};
  mju_copy4(m.geom_quat + 4 * floor, quat);
  m.geom_sameframe[floor] = 0;
  // MuJoCo takes the larger one of two.
  for (int geom = 0; geom < m.ngeom; ++geom)
    m.geom_friction[3 * geom] = std::min(m.geom_friction[3 * geom], kSlopeFriction);
}

class SimReady {
 public:
  SimReady(const mjModel& m, const Subject& subject, Verdict& verdict)
      : m_(m), subject_(subject), verdict_(verdict) {}

  Result::SimReady Check(Workspace& workspace, const Drives& drives) {
    Result::SimReady passes;
    const Scene scene = SceneOf(m_);
    const engine::Model copy(mj_copyModel(nullptr, &m_));
    if (scene.floor >= 0 && !scene.roots.empty()) {
      passes.ground_drop = Judge("ground_drop", Run(*copy, workspace, scene, &Fall::Drop));
      Tilt(*copy, scene.floor);
      passes.slope_drop = Judge("slope_drop", Run(*copy, workspace, scene, &Fall::Slide));
    }
    if (drives.joints.empty()) return passes;
    passes.full_range_sweep = Judge("full_range_sweep", Sweep(drives));
    passes.self_collision = Judge("self_collision", Collisions(drives));
    return passes;
  }

 private:
  std::string Run(mjModel& m, Workspace& workspace, const Scene& scene,
                  std::string (Fall::*test)()) {
    for (;;) {
      mjData& d = workspace.For(m);
      std::string problem = (Fall(m, d, scene, verdict_.checks()).*test)();
      if (!MakeRoom(m, d)) return problem;
    }
  }

  std::string Sweep(const Drives& drives) const {
    for (const Driven& driven : drives.joints) {
      const Result::Joint& joint = driven.measured;
      const bool slides = m_.jnt_type[driven.joint] == mjJNT_SLIDE;
      const double most = slides ? kReachOfSlide * driven.range : kReach;
      const auto more = [&](const char* words, double value, double limit) {
        const Beyond beyond(slides ? 1000 * value : value, slides ? 1000 * limit : limit);
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
    return "";
  }

  std::string Collisions(const Drives& drives) const {
    const double most = verdict_.checks().joint_penetration;
    for (const Jam& jam : drives.jams) {
      if (jam.depth > most)
        return fmt::format("bodies '{}' and '{}' are {} mm in each other",
                           compiled::NameOf(m_, mjOBJ_BODY, jam.body1),
                           compiled::NameOf(m_, mjOBJ_BODY, jam.body2),
                           RoundedText(1000 * jam.depth));
    }
    for (const Driven& driven : drives.joints) {
      if (driven.measured.penetration > most)
        return fmt::format("joint '{}' pushes bodies '{}' and '{}' {} mm into each other",
                           driven.measured.name, driven.body1, driven.body2,
                           RoundedText(1000 * driven.measured.penetration));
    }
    return "";
  }

  std::string Judge(std::string_view test, const std::string& problem) {
    if (problem.empty()) return kPass;
    verdict_.Error(diag::Code::kPhysicsSimReady, subject_.mark,
                   fmt::format("'{}' fails {}: {}", subject_.name, test, problem),
                   "docs/physics.md says what the SimReady benchmark asks for");
    return kFail;
  }

  const mjModel& m_;
  const Subject& subject_;
  Verdict& verdict_;
};

}  // namespace

void CheckSimReady(const mjModel& m, Workspace& workspace, const Drives& drives,
                   const Subject& subject, Verdict& verdict, Result& result) {
  result.simready = SimReady(m, subject, verdict).Check(workspace, drives);
}

}  // namespace mjforge::physics
