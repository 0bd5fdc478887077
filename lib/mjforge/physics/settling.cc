// Settling test: simulates an object from its start, and reports free bodies that do not stay where
// they start.
#include "mjforge/physics/model_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/floor.h"
#include "mjforge/physics/named_elements.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;

constexpr double kLandingTime = 0.05;  // s, time in which a body touches down on its supports
constexpr double kUpwards = 0.5;       // least |z| of the normal of a supporting contact
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

/// A free body, and the bodies that it stands on.
struct FreeBody {
  int body = 0;
  model::Pose start;       // pose at the start, from PoseOf()
  std::set<int> supports;  // supporting bodies; 0: the world
  double distance = 0;     // m, displacement
  double angle = 0;        // rad, rotation
};

class SettlingSimulation {
 public:
  SettlingSimulation(mjModel& m, mjData& d, const model::SettlingCheck& limits)
      : m_(m), d_(d), limits_(limits), stepper_(m, d) {
    for (const int body : FreeBodies(m)) bodies_.emplace_back().body = body;
    // Measures motions relative to the root of the object, which is the first body of the world, if
    // the root is free.
    if (!bodies_.empty() && bodies_.front().body == 1) {
      reference_ = 1;
      bodies_.erase(bodies_.begin());
    }
  }

  std::vector<FreeBody> Run() {
    compiled::CopyStart(m_, d_);
    mj_kinematics(&m_, &d_);
    const Ground ground = GroundOf(m_, d_);
    if (ground.is_level_floor()) LiftFreeBodies(m_, d_, ground.height + LargestMargin(m_));
    mj_forward(&m_, &d_);
    for (FreeBody& body : bodies_) body.start = PoseOf(body.body);
    const int steps = static_cast<int>(std::ceil(limits_.time / m_.opt.timestep));
    for (int step = 0; step < steps && !HasDiverged(d_) && !IsCrowded(d_); ++step) {
      stepper_.Step();
      if (step * m_.opt.timestep < kLandingTime) AddSupports();
    }
    mj_forward(&m_, &d_);
    for (FreeBody& body : bodies_) {
      const model::Pose motion = body.start.Inverse() * PoseOf(body.body);
      body.distance = motion.p.norm();
      body.angle = motion.q.angularDistance(Eigen::Quaterniond::Identity());
    }
    return std::move(bodies_);
  }

 private:
  /// Returns the pose of a body in the frame of the reference body, with the centre of mass of the
  /// body as origin. Bodies that joints attach to the body, such as a lid that falls shut, do not
  /// count for this centre of mass.
  model::Pose PoseOf(int body) const {
    const auto turn = [&](int of) { return compiled::QuaternionAt(d_.xquat, of); };
    const model::Pose X_WB = {compiled::VectorAt(d_.xipos, body), turn(body)};
    const model::Pose X_WR = {compiled::VectorAt(d_.xpos, reference_), turn(reference_)};
    return X_WR.Inverse() * X_WB;
  }

  void AddSupports() {
    for (const mjContact& contact : ContactsOf(d_)) {
      const double up = contact.frame[2];  // vertical part of the normal from geom1 to geom2
      if (std::abs(up) < kUpwards) continue;
      const int first = m_.geom_bodyid[contact.geom1];
      const int second = m_.geom_bodyid[contact.geom2];
      const int upper = m_.body_rootid[up > 0 ? second : first];
      const int lower = up > 0 ? first : second;
      const auto found = std::ranges::find(bodies_, upper, &FreeBody::body);
      if (found != bodies_.end() && upper != m_.body_rootid[lower]) found->supports.insert(lower);
    }
  }

  mjModel& m_;
  mjData& d_;
  const model::SettlingCheck& limits_;
  int reference_ = 0;  // body relative to which motions are measured; 0: the world
  std::vector<FreeBody> bodies_;
  Stepper stepper_;
};

// Returns the text of a number rounded to hundredths, because a body at rest still moves by
// picometres.
std::string HundredthsText(double number) {
  return expr::RoundedText(std::round(100 * number) / 100);
}

std::string SupportText(const ModelTest& test, const FreeBody& body) {
  if (body.supports.empty()) return "it starts on nothing";
  std::string names;
  for (const int support : body.supports) {
    if (!names.empty()) names += ", ";
    names += support == 0
                 ? "the floor"
                 : fmt::format("'{}'", OwnName(test.m, mjOBJ_BODY, support, test.object.name));
  }
  return "it stands on " + names;
}

}  // namespace

void CheckSettled(const ModelTest& test) {
  const model::SettlingCheck& limits = *test.checks().settled;
  if (!(limits.time / test.m.opt.timestep <= kMostSteps)) {
    test.reporter.Error(Code::kPhysicsUnstable, limits.mark,
                        fmt::format("'{}' cannot be simulated: {:g} s in steps of {:g} s",
                                    test.object.name, limits.time, test.m.opt.timestep),
                        fmt::format("use a time of at most {:g} steps", kMostSteps));
    return;
  }
  bool has_diverged = false;
  const std::vector<FreeBody> bodies = Simulate(test.m, test.workspace, [&](mjData& d) {
    std::vector<FreeBody> simulated = SettlingSimulation(test.m, d, limits).Run();
    has_diverged = HasDiverged(d);
    return simulated;
  });
  if (has_diverged) {
    test.reporter.Error(Code::kPhysicsUnstable, limits.mark,
                        fmt::format("the simulation diverges as '{}' settles", test.object.name));
    return;
  }
  Result::Settling settling;
  settling.bodies = static_cast<int>(bodies.size());
  for (const FreeBody& body : bodies) {
    settling.distance = std::max(settling.distance, body.distance);
    settling.angle = std::max(settling.angle, body.angle);
    if (body.distance <= limits.moved && body.angle <= limits.turned) continue;
    ++settling.moved;
    test.reporter.Error(
        Code::kPhysicsNotSettled, limits.mark,
        fmt::format("'{}' moves by {} mm and turns by {} deg within {:g} s; {}",
                    OwnName(test.m, mjOBJ_BODY, body.body, test.object.name),
                    HundredthsText(1000 * body.distance),
                    HundredthsText(kDegreesPerRadian * body.angle), limits.time,
                    SupportText(test, body)),
        body.supports.empty()
            ? "start it where it touches what it is to stand on"
            : "start it where it can rest, or allow more motion: `settled: {moved, turned}`");
  }
  test.result.settled = settling;
}

}  // namespace mjforge::physics
