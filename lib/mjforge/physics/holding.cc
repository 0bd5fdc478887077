#include "mjforge/physics/holding.h"

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
#include "mjforge/physics/added.h"
#include "mjforge/physics/named.h"
#include "mjforge/physics/rounding.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

using diag::Code;
using Eigen::Vector3d;

constexpr double kStay = 3;        // s, how long the balls have to stay
constexpr double kTurn = 1;        // s, for half a turn
constexpr double kPour = 3;        // s, for the balls to come out, the turn included
constexpr double kDensity = 2500;  // kg/m^3, of glass
// Off the middle, as a share of the radius: balls do not stand on each other, and still fall
// through a bottle's neck.
constexpr double kOffMiddle = 0.1;
constexpr double kSoft = 0.001;                     // m, how deep a contact may be
constexpr double kFall = 0.3;                       // s, from a rim to beside the object
constexpr double kGoldenAngle = 2.399963229728653;  // rad, pi (3 - sqrt(5))

std::string BallName(int ball) { return fmt::format("{}ball-{}", kAddedPrefix, ball); }

enum class Where { kAbove, kIn, kOverTheTop, kBelowTheTop };

struct Ball {
  int index = 0;
  int qpos = 0;       // where its position stands in mjData.qpos
  double radius = 0;  // m
  Where where = Where::kAbove;
  Vector3d p_W = Vector3d::Zero();  // m, where it is, or was as it left the object
  bool was_deep = false;            // far below the top
  double rose = -1;                 // s, when it was last near the top after it was deep
};

/// In equal ratios, m. The largest comes first: dropped later, it would drive the small ones
/// through the wall like a hammer.
double RadiusOf(const model::Holding& holding, int ball) {
  const double share = holding.balls > 1 ? static_cast<double>(ball) / (holding.balls - 1) : 0;
  return holding.ball.y() / 2 * std::pow(holding.ball.x() / holding.ball.y(), share);
}

/// What became of the balls.
struct Outcome {
  bool blown_up = false;
  std::vector<Ball> lost;    // as they were to stay
  std::vector<Ball> leaked;  // as it was turned over
  std::vector<Ball> kept;    // when it was
};

/// `without`: a body that is not there; 0: all are.
class Container {
 public:
  Container(mjModel& m, mjData& d, std::span<const mjtNum> start, const model::Holding& holding,
            int without)
      : m_(m), d_(d), first_(mj_name2id(&m, mjOBJ_BODY, BallName(0).c_str())) {
    if (first_ < 0) throw std::runtime_error("the balls are not in its world");
    const int qpos = m.jnt_qposadr[m.body_jntadr[first_]];
    for (int i = 0; i < holding.balls; ++i)
      balls_.push_back({i, qpos + 7 * i, RadiusOf(holding, i)});
    if (without > 0) TakeAway(without);
    stepper_.emplace(m, d);
    Hold(start);
    if (box_.empty()) box_.min = box_.max = Vector3d(Vector3d::Zero());
    Place(holding);
  }

  Outcome Run(bool turn_over) {
    Outcome outcome;
    for (double time = 0; time < kStay && !HasBlownUp(d_); time += m_.opt.timestep) Step(0);
    const auto inside = std::partition(balls_.begin(), balls_.end(),
                                       [](const Ball& ball) { return ball.where != Where::kIn; });
    outcome.lost.assign(balls_.begin(), inside);
    balls_.erase(balls_.begin(), inside);
    if (turn_over) TurnOver(outcome);
    outcome.blown_up = HasBlownUp(d_);
    return outcome;
  }

 private:
  void TurnOver(Outcome& outcome) {
    const auto is_in = [](const Ball& ball) { return ball.where == Where::kIn; };
    for (double time = 0; time < kPour && std::ranges::any_of(balls_, is_in) && !HasBlownUp(d_);
         time += m_.opt.timestep) {
      Step(std::numbers::pi * std::min(time / kTurn, 1.0));
    }
    for (const Ball& ball : balls_) {
      if (ball.where == Where::kIn) outcome.kept.push_back(ball);
      // It may have left over a rim that something else is higher than, but not so low.
      const bool low = 2 * ball.p_W.z() < box_.min.z() + box_.max.z();
      if (ball.where == Where::kBelowTheTop && low) outcome.leaked.push_back(ball);
    }
  }

  void TakeAway(int taken) {
    for (int i = 0; i < m_.ngeom; ++i) {
      int body = m_.geom_bodyid[i];
      while (body > taken) body = m_.body_parentid[body];
      if (body == taken) m_.geom_contype[i] = m_.geom_conaffinity[i] = 0;
    }
  }

  /// The object, in that pose, as if it were fixed to the world.
  void Hold(std::span<const mjtNum> pose) {
    const int count = static_cast<int>(balls_.size());
    PlaceOthers(m_, d_, pose, m_.body_jntadr[first_], 7 * count);
    HoldOthers(m_, m_.body_dofadr[first_], 6 * count);
    mj_kinematics(&m_, &d_);
    for (int body = 1; body < m_.nbody; ++body) {
      const bool is_ball = body >= first_ && body < first_ + count;
      if (m_.body_parentid[body] == 0 && !is_ball) box_.Add(compiled::CollidingBox(m_, d_, body));
    }
  }

  void Place(const model::Holding& holding) {
    const Vector3d middle = (box_.min + box_.max) / 2;
    double height = box_.max.z() + holding.drop;
    for (const Ball& ball : balls_) {
      const double angle = kGoldenAngle * ball.index;
      mjtNum* p = d_.qpos + ball.qpos;
      p[0] =
          (holding.at ? holding.at->x() : middle.x()) + kOffMiddle * ball.radius * std::cos(angle);
      p[1] =
          (holding.at ? holding.at->y() : middle.y()) + kOffMiddle * ball.radius * std::sin(angle);
      p[2] = height + ball.radius;
      height += 2.1 * ball.radius;
    }
  }

  /// With gravity turned by that angle about the x axis.
  void Step(double angle) {
    m_.opt.gravity[0] = 0;
    m_.opt.gravity[1] = kEarthGravity * std::sin(angle);
    m_.opt.gravity[2] = -kEarthGravity * std::cos(angle);
    stepper_->Step();
    for (Ball& ball : balls_) {
      if (ball.where == Where::kAbove || ball.where == Where::kIn) Follow(ball);
    }
  }

  void Follow(Ball& ball) {
    ball.p_W = Eigen::Map<const Vector3d>(d_.qpos + ball.qpos);
    const double depth = box_.max.z() - ball.p_W.z();
    const bool beside = ((ball.p_W - box_.max).array() > ball.radius).any() ||
                        ((box_.min - ball.p_W).array() > ball.radius).any();
    const bool near_top = depth < 2 * ball.radius;
    if (depth > 3 * ball.radius) ball.was_deep = true;
    if (near_top && ball.was_deep) ball.rose = d_.time;
    if (depth < kSoft - ball.radius) {
      ball.where = Where::kAbove;
    } else if (!beside) {
      ball.where = Where::kIn;
    } else {
      // Over a round rim it falls into a corner of the box first.
      const bool over = ball.where == Where::kAbove || near_top || d_.time - ball.rose < kFall;
      ball.where = over ? Where::kOverTheTop : Where::kBelowTheTop;
    }
  }

  mjModel& m_;
  mjData& d_;
  int first_ = 0;  // body
  std::vector<Ball> balls_;
  model::Box3 box_;  // of the object
  std::optional<Stepper> stepper_;
};

std::string Place(const Ball& ball) {
  const Vector3d mm = 1000 * ball.p_W;
  return fmt::format("one of {} mm in diameter at ({}, {}, {}) mm", RoundedText(2000 * ball.radius),
                     RoundedText(mm.x()), RoundedText(mm.y()), RoundedText(mm.z()));
}

class Report {
 public:
  Report(const std::string& name, Verdict& verdict)
      : name_(name), holding_(*verdict.checks().holds), verdict_(verdict) {}

  void All(const Outcome& outcome) {
    if (outcome.blown_up) {
      verdict_.Error(Code::kPhysicsUnstable, holding_.mark,
                     fmt::format("the simulation diverges as balls drop into '{}'", name_));
      return;
    }
    Lost(outcome.lost, "");
    Lost(outcome.leaked, " as it is turned over");
    if (outcome.kept.empty()) return;
    verdict_.Error(Code::kPhysicsKeeps, holding_.mark,
                   fmt::format("'{}' keeps {} as it is turned over: {}", name_, Some(outcome.kept),
                               Place(outcome.kept.front())),
                   "give it a wider mouth, or say `empties: false` if they are to stay inside");
  }

 private:
  std::string Some(const std::vector<Ball>& balls) const {
    return fmt::format("{} of {} ball{}", balls.size(), holding_.balls,
                       holding_.balls == 1 ? "" : "s");
  }

  void Lost(const std::vector<Ball>& lost, std::string_view when) {
    if (lost.empty()) return;
    const auto leak = std::ranges::find(lost, Where::kBelowTheTop, &Ball::where);
    const bool leaks = leak != lost.end();
    verdict_.Error(Code::kPhysicsLeaks, holding_.mark,
                   fmt::format("'{}' loses {}{}: {}, {} its top", name_, Some(lost), when,
                               Place(leaks ? *leak : lost.front()), leaks ? "below" : "over"),
                   leaks ? "make the wall thicker or its contacts harder (a shorter `solref`), and "
                           "look for a lid that is closed"
                         : "let them fall less far (`drop`) or elsewhere (`at`), or take fewer");
  }

  const std::string& name_;
  const model::Holding& holding_;
  Verdict& verdict_;
};

/// The body that is taken away, as the spec or the file names it; 0: none. -1 after a finding.
int TakenAway(const mjModel& m, const std::string& object, Verdict& verdict) {
  const model::Holding& holding = *verdict.checks().holds;
  if (holding.without.empty()) return 0;
  return FindNamed(m, mjOBJ_BODY, object, holding.without, {"holds", holding.mark}, verdict);
}

}  // namespace

std::string WithBalls(std::string_view text, const model::Holding& holding) {
  std::string balls;
  for (int i = 0; i < holding.balls; ++i) {
    const double radius = RadiusOf(holding, i);
    const double mass = kDensity * 4 / 3 * std::numbers::pi * radius * radius * radius;
    balls += fmt::format(R"(<body name="{}"><freejoint/>{}</body>)", BallName(i),
                         AddedGeom(fmt::format(R"(type="sphere" size="{}")", radius), mass));
  }
  return WithBodies(text, balls);
}

void CheckHolding(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                  const std::string& name, Verdict& verdict, Result& result) {
  const model::Holding& holding = *verdict.checks().holds;
  const int without = TakenAway(m, name, verdict);
  while (without >= 0) {
    mjData& d = workspace.For(m);
    const Outcome outcome = Container(m, d, start, holding, without).Run(holding.empties);
    if (MakeRoom(m, d)) continue;
    Report(name, verdict).All(outcome);
    if (outcome.blown_up) return;
    const auto count = [](const std::vector<Ball>& balls) {
      return static_cast<int>(balls.size());
    };
    const int held = holding.balls - count(outcome.lost);
    const int emptied = held - count(outcome.leaked) - count(outcome.kept);
    result.holds = {holding.balls, held, holding.empties ? emptied : 0};
    return;
  }
}

}  // namespace mjforge::physics
