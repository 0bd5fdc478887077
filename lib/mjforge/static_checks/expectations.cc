// Check of the expectations of a spec: gaps between bodies or parts, and bodies or parts inside the
// convex hulls of others.
#include "mjforge/static_checks/static_checks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <queue>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "mjforge/static_checks/placed_part.h"

namespace mjforge::static_checks {
namespace {

using Eigen::Vector3d;
using model::Expectation;
using Kind = model::ExpectationKind;
using PlacedParts = std::vector<PlacedPart>;

constexpr double kTolerance = 1e-5;  // m, for kTouch, kApart and kInside
constexpr int kDigits = 3;           // number of significant digits of lengths in messages

// Formats the absolute value of a length: "0.132 mm".
std::string LengthText(double length, int digits = kDigits) {
  return expr::RoundedText(1000 * std::abs(length), digits) + " mm";
}

// Returns a number of significant digits with which the texts of two lengths differ.
int DigitsFor(double a, double b) {
  int digits = kDigits;
  while (digits < 15 && LengthText(a, digits) == LengthText(b, digits)) digits += 3;
  return digits;
}

// Returns directions, in the frame of a round shape, whose support points form a grid on the
// shape's surface.
std::vector<Vector3d> DirectionsOfGrid() {
  constexpr int kAround = 64;
  constexpr int kUp = 16;
  std::vector<Vector3d> directions;
  for (int i = 0; i < kAround; ++i) {
    const double a = 2 * std::numbers::pi * (i + 0.5) / kAround;
    for (int j = 0; j <= kUp; ++j) {
      const double b = std::numbers::pi * (static_cast<double>(j) / kUp - 0.5);
      directions.emplace_back(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
    }
  }
  return directions;
}

const std::vector<Vector3d>& DirectionsOf(const model::Shape& shape) {
  // Directions whose support points are the corners of a box.
  static const std::vector<Vector3d> kOfBox =
      model::VerticesOf({.type = model::GeomType::kBox, .size = Vector3d::Ones()});
  static const std::vector<Vector3d> kOfRound = DirectionsOfGrid();
  return shape.type == model::GeomType::kBox ? kOfBox : kOfRound;
}

class ExpectationChecker {
 public:
  ExpectationChecker(const model::Object& object, diag::Findings& findings)
      : object_(object), findings_(findings) {}

  void Check(const Expectation& expectation) {
    expectation_ = &expectation;
    poses_ = model::SubtreePoses(object_.bodies, 0, expectation.positions);
    PlacedParts second = PlacedPartsOf(expectation.second, nullptr);
    const PlacedParts first = PlacedPartsOf(expectation.first, OnlyPart(second));
    if (const model::Part* const part = OnlyPart(first))
      second = PlacedPartsOf(expectation.second, part);
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
  static const model::Part* OnlyPart(const PlacedParts& placed) {
    return placed.size() == 1 ? placed.front().part : nullptr;
  }

  // Returns the parts of the body `name` and of the bodies fixed to it, except `other`. If no body
  // has this name, returns the parts with this name, and the pieces of a shape with this name.
  // Omits visual parts if any of these parts collides.
  PlacedParts PlacedPartsOf(const std::string& name, const model::Part* other) const {
    const auto body = std::ranges::find(object_.bodies, name, &model::Body::name);
    // Parts, and the indices of their bodies.
    std::vector<std::pair<const model::Part*, std::size_t>> parts;
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
    PlacedParts placed;
    placed.reserve(parts.size());
    for (const auto& [part, i] : parts) placed.emplace_back(part, poses_[i] * part->X_BG);
    return placed;
  }

  // Returns the index of the nearest body, among body `i` and the ancestors to which it is fixed,
  // that the expectation names. If the expectation names none, returns the highest ancestor.
  std::size_t Holder(std::size_t i) const {
    const auto is_named = [&](std::size_t at) {
      return object_.bodies[at].name == expectation_->first ||
             object_.bodies[at].name == expectation_->second;
    };
    while (!is_named(i) && object_.bodies[i].joints.empty() && object_.bodies[i].parent >= 0)
      i = static_cast<std::size_t>(object_.bodies[i].parent);
    return i;
  }

  void CheckGap(const PlacedParts& first, const PlacedParts& second) {
    const auto& [kind, a, b, min, max, positions, doc, mark] = *expectation_;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    // Gaps from `least` to `most` meet the expectation.
    double least = -kInfinity;
    double most = kInfinity;
    if (kind == Kind::kApart) least = -kTolerance;
    if (kind == Kind::kTouch) most = kTolerance;
    if (min) least = *min - kRounding;
    if (max) most = *max + kRounding;
    // Computes depths of overlaps only if they matter: if there is a lower limit, or an upper limit
    // below zero. The depth takes most of the time.
    auto* const distance_of =
        least > -kInfinity || most < 0 ? distance::SignedDistance : distance::Distance;
    double gap = kInfinity;
    PartPair nearest;
    for (PairQueue pairs = PairsOf(first, second); !pairs.empty(); pairs.pop()) {
      const PartPair pair = pairs.top();
      // Stops if no remaining pair is nearer, or if none can change the verdict.
      if (pair.least >= gap || (pair.least >= least && gap <= most)) break;
      const double distance = distance_of(*pair.a, *pair.b);
      if (distance >= gap) continue;
      gap = distance;
      nearest = pair;
    }
    if (gap < least) ReportGap(gap, nearest, min, "least", "not be in each other");
    if (gap > most) ReportGap(gap, nearest, max, "most", "touch");
  }

  struct PartPair {
    // Lower bound of the distance of the parts, m: the distance of their bounding boxes, or minus
    // infinity if the boxes touch or overlap.
    double least = 0;
    const PlacedPart* a = nullptr;
    const PlacedPart* b = nullptr;

    auto operator<=>(const PartPair&) const = default;
  };
  // The pair with the smallest lower bound is first.
  using PairQueue = std::priority_queue<PartPair, std::vector<PartPair>, std::greater<>>;

  static PairQueue PairsOf(const PlacedParts& first, const PlacedParts& second) {
    std::vector<PartPair> pairs;
    for (const PlacedPart& a : first) {
      for (const PlacedPart& b : second) {
        const double apart = a.box_W.exteriorDistance(b.box_W);
        pairs.push_back({apart > 0 ? apart : -std::numeric_limits<double>::infinity(), &a, &b});
      }
    }
    return PairQueue(std::greater<>(), std::move(pairs));
  }

  // Reports a gap that violates a bound. `side` is "least" or "most". If `bound` is nullopt, the
  // message says `otherwise` instead of a length ("must touch").
  void ReportGap(double gap, const PartPair& nearest, std::optional<double> bound,
                 std::string_view side, std::string_view otherwise) {
    const int digits = bound ? DigitsFor(gap, *bound) : kDigits;
    const std::string must = bound ? fmt::format("be at {} {}{} apart", side, *bound < 0 ? "-" : "",
                                                 LengthText(*bound, digits))
                                   : std::string(otherwise);
    const bool touch = std::abs(gap) < (expectation_->kind == Kind::kGap ? kRounding : kTolerance);
    const std::string is =
        touch ? std::string("touching")
              : fmt::format("{} {}", LengthText(gap, digits), gap < 0 ? "in each other" : "apart");
    Report(fmt::format("'{}' and '{}' must {}, but are {}{}", Shown(expectation_->first),
                       Shown(expectation_->second), must, is, PartsText(*nearest.a, *nearest.b)));
  }

  void CheckInside(const PlacedParts& first, const PlacedParts& second) {
    double farthest = 0;
    const PlacedPart* out = nullptr;
    const std::vector<distance::PlacedShape> hull(second.begin(), second.end());
    for (const PlacedPart& placed : first) {
      const double outside = Outside(placed, hull);
      if (outside <= farthest) continue;
      farthest = outside;
      out = &placed;
    }
    if (farthest <= kTolerance) return;
    const bool is_part = out->part->name == expectation_->first;
    Report(fmt::format("'{}' must be inside '{}', but is {} outside{}", Shown(expectation_->first),
                       Shown(expectation_->second), LengthText(farthest),
                       is_part ? "" : fmt::format(" (part '{}')", Shown(out->part->name))));
  }

  // Returns the largest distance, m, of any point of the part from the convex hull of all shapes in
  // `hull`.
  static double Outside(const PlacedPart& placed, std::span<const distance::PlacedShape> hull) {
    std::vector<Vector3d> points;
    if (placed.part->shape.mesh != nullptr) {
      for (const Vector3d& vertex : placed.part->shape.mesh->vertices)
        points.push_back(placed.X_WG * vertex);
    } else {
      for (const Vector3d& direction : DirectionsOf(placed.part->shape))
        points.push_back(FarthestPoint(placed, placed.X_WG.q * direction));
    }
    Vector3d way = Vector3d::Zero();
    for (const Vector3d& point : points) {
      const Vector3d from = FromHull(hull, point);
      if (from.norm() > way.norm()) way = from;
    }
    // Refines the result, because between the sampled points a round shape may be farther away
    // from the hull.
    for (int i = 0; i < 20 && way.norm() > 0; ++i) {
      const Vector3d from = FromHull(hull, FarthestPoint(placed, way));
      if (from.norm() <= way.norm() * (1 + 1e-9)) break;
      way = from;
    }
    return way.norm();
  }

  // Returns a name as written in the spec; the root body has the name of the object.
  std::string_view Shown(std::string_view name) const {
    return name == object_.bodies.front().name ? std::string_view(object_.name)
                                               : model::OwnName(name, object_.name);
  }

  // Returns " (parts ...)", or an empty text if the expectation names the parts themselves.
  std::string PartsText(const PlacedPart& a, const PlacedPart& b) const {
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

  static constexpr double kRounding = 1e-9;  // m, tolerance of the bounds `min` and `max`

  const model::Object& object_;
  diag::Findings& findings_;
  const Expectation* expectation_ = nullptr;
  std::vector<model::Pose> poses_;  // X_WB of each body
};

}  // namespace

void CheckExpectations(const model::Object& object, diag::Findings& findings) {
  for (const diag::Finding& finding : object.unmet_expectations) findings.Add(finding);
  ExpectationChecker checker(object, findings);
  for (const Expectation& expectation : object.expectations) checker.Check(expectation);
}

}  // namespace mjforge::static_checks
