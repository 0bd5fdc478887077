#include "mjforge/expect/expect.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "mjforge/expect/distance.h"
#include "mjforge/expect/motion.h"

namespace mjforge::expect {
namespace {

using Eigen::Vector3d;
using model::Expectation;
using Kind = model::ExpectationKind;
using Solids = std::vector<Solid>;

constexpr int kDigits = 3;

// "0.132 mm".
std::string LengthText(double length, int digits = kDigits) {
  const double mm = 1000 * std::abs(length);
  return mm < 100 || digits > kDigits ? fmt::format("{:.{}g} mm", mm, digits)
                                      : fmt::format("{:.0f} mm", mm);
}

// As many digits as tell the two apart.
int DigitsFor(double a, double b) {
  int digits = kDigits;
  while (digits < 15 && LengthText(a, digits) == LengthText(b, digits)) digits += 3;
  return digits;
}

// In a shape's frame, directions whose farthest points tell where it ends. Of a box those are its
// corners; of round shapes there are others between them.
std::vector<Vector3d> MakeDirections(bool is_box) {
  const int around = is_box ? 4 : 64;
  const int up = is_box ? 3 : 16;
  std::vector<Vector3d> directions;
  for (int i = 0; i < around; ++i) {
    const double a = 2 * std::numbers::pi * (i + 0.5) / around;
    for (int j = 0; j <= up; ++j) {
      const double b = std::numbers::pi * (static_cast<double>(j) / up - 0.5);
      directions.emplace_back(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
    }
  }
  return directions;
}

const std::vector<Vector3d>& DirectionsOf(const model::Shape& shape) {
  static const std::vector<Vector3d> kOfBox = MakeDirections(true);
  static const std::vector<Vector3d> kOfRound = MakeDirections(false);
  return shape.type == model::GeomType::kBox ? kOfBox : kOfRound;
}

class Checker {
 public:
  Checker(const model::Object& object, diag::Findings& findings)
      : object_(object), findings_(findings) {}

  void Check(const Expectation& expectation) {
    expectation_ = &expectation;
    poses_ = PosesAt(object_, expectation.positions);
    Solids second = SolidsOf(expectation.second, nullptr);
    const Solids first = SolidsOf(expectation.first, OnlyPart(second));
    if (const model::Part* const part = OnlyPart(first))
      second = SolidsOf(expectation.second, part);
    if (first.empty() || second.empty()) {
      Report(fmt::format("'{}' has no parts",
                         Shown(first.empty() ? expectation.first : expectation.second)));
    } else if (expectation.kind == Kind::kInside) {
      CheckInside(first, second);
    } else {
      CheckGap(first, second);
    }
  }

 private:
  static const model::Part* OnlyPart(const Solids& solids) {
    return solids.size() == 1 ? solids.front().part : nullptr;
  }

  // The parts that a name stands for: a body's own, and those of bodies that are fixed to it,
  // without the `other` that the expectation names. What is only visual counts where nothing
  // collides.
  Solids SolidsOf(const std::string& name, const model::Part* other) const {
    const auto body = std::ranges::find(object_.bodies, name, &model::Body::name);
    std::vector<std::pair<const model::Part*, std::size_t>> parts;  // with their bodies
    for (std::size_t i = 0; i < object_.bodies.size(); ++i) {
      const bool is_part = body == object_.bodies.end();
      if (!is_part && Holder(i) != static_cast<std::size_t>(body - object_.bodies.begin()))
        continue;
      for (const model::Part& part : object_.bodies[i].parts) {
        if (is_part && part.name != name && part.piece_of != name) continue;
        if (!is_part && &part == other) continue;
        parts.emplace_back(&part, i);
      }
    }
    const auto is_visual = [](const auto& of) { return of.first->role == model::Role::kVisual; };
    if (!std::ranges::all_of(parts, is_visual)) std::erase_if(parts, is_visual);
    Solids solids;
    solids.reserve(parts.size());
    for (const auto& [part, i] : parts) solids.emplace_back(part, poses_[i] * part->X_BG);
    return solids;
  }

  // The body that a body is fixed to and moves with, as far up as that of a name.
  std::size_t Holder(std::size_t i) const {
    const auto is_named = [&](std::size_t at) {
      return object_.bodies[at].name == expectation_->first ||
             object_.bodies[at].name == expectation_->second;
    };
    while (!is_named(i) && object_.bodies[i].joints.empty() && object_.bodies[i].parent >= 0)
      i = static_cast<std::size_t>(object_.bodies[i].parent);
    return i;
  }

  void CheckGap(const Solids& first, const Solids& second) {
    const auto& [kind, a, b, min, max, positions, doc, mark] = *expectation_;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    // From `least` to `most` it is as expected.
    double least = -kInfinity;
    double most = kInfinity;
    if (kind == Kind::kApart) least = -kTolerance;
    if (kind == Kind::kTouch) most = kTolerance;
    if (min) least = *min - kRounding;
    if (max) most = *max + kRounding;
    double gap = kInfinity;
    Pair nearest;
    for (Pairs pairs = PairsOf(first, second); !pairs.empty(); pairs.pop()) {
      const Pair pair = pairs.top();
      // The others are as far apart, or farther.
      if (pair.least >= gap || (pair.least >= least && gap <= most)) break;
      const double distance = SignedDistance(*pair.a, *pair.b);
      if (distance >= gap) continue;
      gap = distance;
      nearest = pair;
    }
    if (gap < least) ReportGap(gap, nearest, min, "least", "not be in each other");
    if (gap > most) ReportGap(gap, nearest, max, "most", "touch");
  }

  struct Pair {
    // The distance of the boxes around them: no more than that of the solids. Less than all if the
    // boxes overlap.
    double least = 0;
    const Solid* a = nullptr;
    const Solid* b = nullptr;

    auto operator<=>(const Pair&) const = default;
  };
  using Pairs = std::priority_queue<Pair, std::vector<Pair>, std::greater<>>;  // the least first

  static Pairs PairsOf(const Solids& first, const Solids& second) {
    std::vector<Pair> pairs;
    for (const Solid& a : first) {
      for (const Solid& b : second) {
        const double apart = a.box_W.exteriorDistance(b.box_W);
        pairs.push_back({apart > 0 ? apart : -std::numeric_limits<double>::infinity(), &a, &b});
      }
    }
    return Pairs(std::greater<>(), std::move(pairs));
  }

  // `side`: of the bound; `otherwise`: what they must where there is none.
  void ReportGap(double gap, const Pair& nearest, std::optional<double> bound,
                 std::string_view side, std::string_view otherwise) {
    const int digits = bound ? DigitsFor(gap, *bound) : kDigits;
    const std::string must = bound ? fmt::format("be at {} {} apart", side, Asked(*bound, digits))
                                   : std::string(otherwise);
    const bool touch = std::abs(gap) < (expectation_->kind == Kind::kGap ? kRounding : kTolerance);
    const std::string is =
        touch ? std::string("touching")
              : fmt::format("{} {}", LengthText(gap, digits), gap < 0 ? "in each other" : "apart");
    Report(fmt::format("{} must {}, but are {}{}", Both(), must, is,
                       PartsText(*nearest.a, *nearest.b)));
  }

  void CheckInside(const Solids& first, const Solids& second) {
    double farthest = 0;
    const Solid* out = nullptr;
    for (const Solid& solid : first) {
      const double outside = Outside(solid, second);
      if (outside <= farthest) continue;
      farthest = outside;
      out = &solid;
    }
    if (farthest <= kTolerance) return;
    const bool is_part = out->part->name == expectation_->first;
    Report(fmt::format("'{}' must be inside '{}', but is {} outside{}", Shown(expectation_->first),
                       Shown(expectation_->second), LengthText(farthest),
                       is_part ? "" : fmt::format(" (part '{}')", Shown(out->part->name))));
  }

  // How far a point of the solid is from the hull, at most.
  static double Outside(const Solid& solid, const Solids& hull) {
    std::vector<Vector3d> points;
    if (solid.part->shape.mesh != nullptr) {
      for (const Vector3d& vertex : solid.part->shape.mesh->vertices)
        points.push_back(solid.X_WG * vertex);
    } else {
      for (const Vector3d& direction : DirectionsOf(solid.part->shape))
        points.push_back(FarthestPoint(solid, solid.X_WG.q * direction));
    }
    Vector3d way = Vector3d::Zero();
    for (const Vector3d& point : points) {
      const Vector3d from = FromHull(hull, point);
      if (from.norm() > way.norm()) way = from;
    }
    // Between the points a round shape may be farther out.
    for (int i = 0; i < 20 && way.norm() > 0; ++i) {
      const Vector3d from = FromHull(hull, FarthestPoint(solid, way));
      if (from.norm() <= way.norm() * (1 + 1e-9)) break;
      way = from;
    }
    return way.norm();
  }

  // As the author of the spec names it.
  std::string_view Shown(std::string_view name) const {
    if (name == object_.bodies.front().name) return object_.name;
    if (name.starts_with(object_.name) && name.substr(object_.name.size()).starts_with('_'))
      name.remove_prefix(object_.name.size() + 1);
    return name;
  }

  std::string Both() const {
    return fmt::format("'{}' and '{}'", Shown(expectation_->first), Shown(expectation_->second));
  }

  static std::string Asked(double length, int digits) {
    return (length < 0 ? "-" : "") + LengthText(length, digits);
  }

  // Which parts it is, unless they are what was named.
  std::string PartsText(const Solid& a, const Solid& b) const {
    if (a.part->name == expectation_->first && b.part->name == expectation_->second) return {};
    return fmt::format(" (parts '{}' and '{}')", Shown(a.part->name), Shown(b.part->name));
  }

  void Report(std::string message) {
    for (const auto& [joint, numbers] : expectation_->positions) {
      message += fmt::format(", at {} =", Shown(joint));
      for (const double number : numbers) message += " " + expr::NumberText(number);
    }
    findings_.Add(diag::Code::kModelExpectation, expectation_->mark, std::move(message),
                  expectation_->doc);
  }

  static constexpr double kRounding = 1e-9;  // m

  const model::Object& object_;
  diag::Findings& findings_;
  const Expectation* expectation_ = nullptr;
  std::vector<model::Pose> poses_;  // X_WB
};

}  // namespace

void CheckExpectations(const model::Object& object, diag::Findings& findings) {
  for (const diag::Finding& finding : object.unmet) findings.Add(finding);
  Checker checker(object, findings);
  for (const Expectation& expectation : object.expectations) checker.Check(expectation);
}

}  // namespace mjforge::expect
