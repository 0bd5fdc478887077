// Containment test: balls dropped into an object that is held in place and then turned over.
#include "mjforge/physics/probe_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/named_elements.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using Eigen::Vector3d;
using expr::RoundedText;

constexpr double kStay = 3;        // s, time for which the balls must stay inside
constexpr double kTurn = 1;        // s, duration of the half turn that empties the object
constexpr double kPour = 3;        // s, time in which the balls must leave, including the half turn
constexpr double kDensity = 2500;  // kg/m^3, glass
// Offset of a ball from the axis of the stack, as a share of the ball's radius: large enough that
// balls do not balance on each other, small enough that they fall through the neck of a bottle.
constexpr double kOffAxis = 0.1;
// Depth of a ball's lowest point below the object's top, m, up to which the ball counts as above
// the object, because contacts are soft.
constexpr double kSoft = 0.001;
// Longest time from when a ball leaves over the rim until the ball is beside the object.
constexpr double kFall = 0.3;                       // s
constexpr double kGoldenAngle = 2.399963229728653;  // rad, pi (3 - sqrt(5))

std::string BallName(int ball) { return fmt::format("{}ball-{}", kProbePrefix, ball); }

/// Place of a ball relative to the bounding box of the object.
enum class BallPlace { kAbove, kInside, kOutOverTheTop, kOutBelowTheTop };

struct Ball {
  int index = 0;
  int qpos = 0;       // index of the ball's position in mjData.qpos
  double radius = 0;  // m
  BallPlace place = BallPlace::kAbove;
  Vector3d p_W = Vector3d::Zero();  // m, position now, or where the ball left the object
  bool was_deep = false;            // the ball has been far below the object's top
  double rose = -1;                 // s, last time near the top after being deep; -1: never
};

/// Returns the radius of a ball, m. Radii decrease from ball to ball by equal ratios. The largest
/// ball is dropped first, because a large ball that falls on smaller balls would push them through
/// the wall.
double RadiusOf(const model::HoldingCheck& holding, int ball) {
  const double share = holding.balls > 1 ? static_cast<double>(ball) / (holding.balls - 1) : 0;
  return holding.ball.y() / 2 * std::pow(holding.ball.x() / holding.ball.y(), share);
}

/// Balls that a containment test found at the wrong place.
struct ContainmentResult {
  bool has_diverged = false;
  std::vector<Ball> lost;    // balls that were not inside after kStay
  std::vector<Ball> leaked;  // balls that went through the wall while the object was turned over
  std::vector<Ball> kept;    // balls that were still inside after the object was turned over
};

/// Simulation of balls that drop into an object. The object is held in place as if fixed to the
/// world; gravity is turned instead of the object.
class ContainmentSimulation {
 public:
  /// Disables the collisions of the body `removed` and of all its descendants; if `removed` is 0,
  /// all bodies collide.
  ContainmentSimulation(mjModel& m, mjData& d, std::span<const mjtNum> start,
                        const model::HoldingCheck& holding, int removed)
      : m_(m), d_(d), first_(mj_name2id(&m, mjOBJ_BODY, BallName(0).c_str())) {
    if (first_ < 0) throw std::runtime_error("the balls are not in its world");
    const int qpos = m.jnt_qposadr[m.body_jntadr[first_]];
    for (int i = 0; i < holding.balls; ++i)
      balls_.push_back({i, qpos + 7 * i, RadiusOf(holding, i)});
    if (removed > 0) Remove(removed);
    stepper_.emplace(m, d);
    Hold(start);
    if (box_.empty()) box_.min = box_.max = Vector3d(Vector3d::Zero());
    PlaceBalls(holding);
  }

  ContainmentResult Run(bool turn_over) {
    ContainmentResult result;
    for (double time = 0; time < kStay && !HasDiverged(d_); time += m_.opt.timestep) Step(0);
    const auto inside = std::partition(balls_.begin(), balls_.end(), [](const Ball& ball) {
      return ball.place != BallPlace::kInside;
    });
    result.lost.assign(balls_.begin(), inside);
    balls_.erase(balls_.begin(), inside);
    if (turn_over) TurnOver(result);
    result.has_diverged = HasDiverged(d_);
    return result;
  }

 private:
  void TurnOver(ContainmentResult& result) {
    const auto is_in = [](const Ball& ball) { return ball.place == BallPlace::kInside; };
    for (double time = 0; time < kPour && std::ranges::any_of(balls_, is_in) && !HasDiverged(d_);
         time += m_.opt.timestep) {
      Step(std::numbers::pi * std::min(time / kTurn, 1.0));
    }
    for (const Ball& ball : balls_) {
      if (ball.place == BallPlace::kInside) result.kept.push_back(ball);
      // A ball that leaves below the top may have crossed a rim that is lower than other parts. A
      // ball in the lower half of the box must have gone through the wall.
      const bool low = 2 * ball.p_W.z() < box_.min.z() + box_.max.z();
      if (ball.place == BallPlace::kOutBelowTheTop && low) result.leaked.push_back(ball);
    }
  }

  void Remove(int removed) {
    const int end = compiled::SubtreeEnd(m_, removed);
    for (int i = 0; i < m_.ngeom; ++i) {
      const int body = m_.geom_bodyid[i];
      if (body >= removed && body < end) m_.geom_contype[i] = m_.geom_conaffinity[i] = 0;
    }
  }

  /// Holds the object in place, and computes its bounding box.
  void Hold(std::span<const mjtNum> pose) {
    const int count = static_cast<int>(balls_.size());
    PlaceObject(m_, d_, pose, m_.body_jntadr[first_], 7 * count);
    HoldOthers(m_, m_.body_dofadr[first_], 6 * count);
    mj_kinematics(&m_, &d_);
    for (int body = 1; body < m_.nbody; ++body) {
      const bool is_ball = body >= first_ && body < first_ + count;
      if (m_.body_parentid[body] == 0 && !is_ball) box_.Add(compiled::CollidingBox(m_, d_, body));
    }
  }

  /// Stacks the balls above the object.
  void PlaceBalls(const model::HoldingCheck& holding) {
    const Vector3d middle = (box_.min + box_.max) / 2;
    double height = box_.max.z() + holding.drop;
    for (const Ball& ball : balls_) {
      const double angle = kGoldenAngle * ball.index;
      mjtNum* p = d_.qpos + ball.qpos;
      p[0] = (holding.at ? holding.at->x() : middle.x()) + kOffAxis * ball.radius * std::cos(angle);
      p[1] = (holding.at ? holding.at->y() : middle.y()) + kOffAxis * ball.radius * std::sin(angle);
      p[2] = height + ball.radius;
      height += 2.1 * ball.radius;
    }
  }

  /// Makes one step with gravity turned by an angle about the x axis, rad.
  void Step(double angle) {
    m_.opt.gravity[0] = 0;
    m_.opt.gravity[1] = kEarthGravity * std::sin(angle);
    m_.opt.gravity[2] = -kEarthGravity * std::cos(angle);
    stepper_->Step();
    for (Ball& ball : balls_) {
      if (ball.place == BallPlace::kAbove || ball.place == BallPlace::kInside) Follow(ball);
    }
  }

  /// Updates the position of a ball, and whether the ball is above, inside or outside the object.
  void Follow(Ball& ball) {
    ball.p_W = Eigen::Map<const Vector3d>(d_.qpos + ball.qpos);
    const double depth = box_.max.z() - ball.p_W.z();
    const bool beside = ((ball.p_W - box_.max).array() > ball.radius).any() ||
                        ((box_.min - ball.p_W).array() > ball.radius).any();
    const bool near_top = depth < 2 * ball.radius;
    if (depth > 3 * ball.radius) ball.was_deep = true;
    if (near_top && ball.was_deep) ball.rose = d_.time;
    if (depth < kSoft - ball.radius) {
      ball.place = BallPlace::kAbove;
    } else if (!beside) {
      ball.place = BallPlace::kInside;
    } else {
      // A ball that leaves over a round rim may fall into a corner of the box first.
      const bool over = ball.place == BallPlace::kAbove || near_top || d_.time - ball.rose < kFall;
      ball.place = over ? BallPlace::kOutOverTheTop : BallPlace::kOutBelowTheTop;
    }
  }

  mjModel& m_;
  mjData& d_;
  int first_ = 0;  // id of the body of the first ball; the other balls follow
  std::vector<Ball> balls_;
  model::Box3 box_;  // bounding box of the object in the world
  std::optional<Stepper> stepper_;
};

std::string BallText(const Ball& ball) {
  const Vector3d mm = 1000 * ball.p_W;
  return fmt::format("one of {} mm in diameter at ({}, {}, {}) mm", RoundedText(2000 * ball.radius),
                     RoundedText(mm.x()), RoundedText(mm.y()), RoundedText(mm.z()));
}

/// Reports the balls that a containment test found at the wrong place.
class ContainmentReport {
 public:
  explicit ContainmentReport(const ProbeTest& test)
      : name_(test.object.name), holding_(*test.checks().holds), reporter_(test.reporter) {}

  void Add(const ContainmentResult& result) {
    if (result.has_diverged) {
      reporter_.Error(Code::kPhysicsUnstable, holding_.mark,
                      fmt::format("the simulation diverges as balls drop into '{}'", name_));
      return;
    }
    AddLost(result.lost, "");
    AddLost(result.leaked, " as it is turned over");
    if (result.kept.empty()) return;
    reporter_.Error(Code::kPhysicsKeeps, holding_.mark,
                    fmt::format("'{}' keeps {} as it is turned over: {}", name_,
                                CountText(result.kept), BallText(result.kept.front())),
                    "give it a wider mouth, or say `empties: false` if they are to stay inside");
  }

 private:
  std::string CountText(const std::vector<Ball>& balls) const {
    const auto all = static_cast<std::uint64_t>(holding_.balls);
    return fmt::format("{} of {}", balls.size(), diag::Counted(all, "ball"));
  }

  void AddLost(const std::vector<Ball>& lost, std::string_view when) {
    if (lost.empty()) return;
    const auto leak = std::ranges::find(lost, BallPlace::kOutBelowTheTop, &Ball::place);
    const bool leaks = leak != lost.end();
    reporter_.Error(Code::kPhysicsLeaks, holding_.mark,
                    fmt::format("'{}' loses {}{}: {}, {} its top", name_, CountText(lost), when,
                                BallText(leaks ? *leak : lost.front()), leaks ? "below" : "over"),
                    leaks
                        ? "make the wall thicker or its contacts harder (a shorter `solref`), and "
                          "look for a lid that is closed"
                        : "let them fall less far (`drop`) or elsewhere (`at`), or take fewer");
  }

  const std::string& name_;
  const model::HoldingCheck& holding_;
  static_checks::Reporter& reporter_;
};

/// Returns the id of the body that `without` in checks.holds names, whose collisions are disabled
/// in the test; 0 if `without` is empty. If the name is unknown, adds a finding and returns
/// nullopt.
std::optional<int> RemovedBody(const ProbeTest& test) {
  const model::HoldingCheck& holding = *test.checks().holds;
  if (holding.without.empty()) return 0;
  return FindNamed(test, mjOBJ_BODY, holding.without, {"holds", holding.mark});
}

}  // namespace

std::string WithBalls(std::string_view text, const model::HoldingCheck& holding) {
  std::string balls;
  for (int i = 0; i < holding.balls; ++i) {
    const double radius = RadiusOf(holding, i);
    const double mass = kDensity * 4 / 3 * std::numbers::pi * radius * radius * radius;
    balls += fmt::format(R"(<body name="{}"><freejoint/>{}</body>)", BallName(i),
                         ProbeGeom(fmt::format(R"(type="sphere" size="{}")", radius), mass));
  }
  return WithBodies(text, balls);
}

void CheckContainment(const ProbeTest& test) {
  const std::optional<int> removed = RemovedBody(test);
  if (!removed) return;
  const model::HoldingCheck& holding = *test.checks().holds;
  const auto result = Simulate(test.m, test.workspace, [&](mjData& d) {
    return ContainmentSimulation(test.m, d, test.start, holding, *removed).Run(holding.empties);
  });
  ContainmentReport(test).Add(result);
  if (result.has_diverged) return;
  const auto count = [](const std::vector<Ball>& balls) { return static_cast<int>(balls.size()); };
  const int held = holding.balls - count(result.lost);
  const int emptied = held - count(result.leaked) - count(result.kept);
  test.result.holds = {holding.balls, held, holding.empties ? emptied : 0};
}

}  // namespace mjforge::physics
