// Check of an object's proportions against those of real things: density, inertia, centre of mass,
// thickness, overlapping and loose parts, and differences of visual and colliding parts.
#include "mjforge/static_checks/static_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include "mjforge/expr/expr.h"
#include "mjforge/static_checks/connected_parts.h"
#include "mjforge/static_checks/mass_overlap.h"
#include "mjforge/static_checks/placed_part.h"
#include "mjforge/static_checks/solid_parts.h"

namespace mjforge::static_checks {
namespace {

using diag::Code;
using expr::ExceededLimit;
using expr::RoundedText;

// Tolerances of principal moments of inertia, as shares of the largest principal moment.
constexpr double kRounding = 1e-6;
constexpr double kNothing = 1e-12;  // moments below this share count as zero
// Largest distance of a visual part from the nearest colliding part, as a share of the body's size.
constexpr double kFar = 0.5;
constexpr double kFaces = 1e-9;  // m; boxes that overlap by at most this only meet at faces
// Largest distance of a body's centre of mass from the hull of its parts, as a share of the body's
// size.
constexpr double kHullTolerance = 5e-4;

std::string OutsideOf(double value, const Eigen::Vector2d& range, std::string_view unit) {
  const bool low = value < range.x();
  const double limit = low ? range.x() : range.y();
  const ExceededLimit beyond(value, limit);
  return fmt::format("{} {}, {} than {}", beyond.value, unit, low ? "less" : "more", beyond.limit);
}

bool IsOutside(double value, const Eigen::Vector2d& range) {
  return value < range.x() || value > range.y();
}

/// Returns the shortest and longest side, m, of the bounding box of a shape in its own frame.
Eigen::Vector2d SidesOf(const model::Shape& shape) {
  const model::Box3 box = model::BoundsOf(shape, {});
  const Eigen::Vector3d sides = box.max - box.min;
  return {sides.minCoeff(), sides.maxCoeff()};
}

std::string WithMore(std::size_t more) {
  return more > 0 ? fmt::format(" with {} more", more) : std::string();
}

/// Returns true if viewers show the part by default. A part of a spec has a visual geom unless its
/// role is `collision`; a geom of a file is shown if its group is 0 to 2.
bool IsSeen(const model::Part& part) {
  return part.as_is ? NumberOf(part, "group", 0, 0) <= 2 : part.role != model::Role::kCollision;
}

using Box = Eigen::AlignedBox3d;

Box BoxOf(const model::Part& part) { return PlacedPart(&part, part.X_BG).box_W; }

std::vector<PlacedPart> Placed(const std::vector<model::Part>& parts) {
  return diag::Mapped<PlacedPart>(
      parts, [](const model::Part& part) { return PlacedPart(&part, part.X_BG); });
}

/// Returns true if a box overlaps one of `boxes` by more than kFaces.
bool Overlaps(const std::vector<Box>& boxes, const Box& box) {
  return std::ranges::any_of(
      boxes, [&](const Box& other) { return box.intersection(other).sizes().minCoeff() > kFaces; });
}

double DistanceTo(const std::vector<Box>& boxes, const Box& box) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Box& other : boxes) nearest = std::min(nearest, box.exteriorDistance(other));
  return nearest;
}

class Proportions {
 public:
  Proportions(const model::Object& object, diag::SourceMark mark, Reporter& reporter)
      : object_(object), mark_(mark), reporter_(reporter) {}

  double Check() {
    CheckPartNames();
    CheckWhole();
    double twice = 0;
    for (const model::Body& body : object_.bodies) {
      const SolidParts solids = SolidPartsOf(body);
      CheckThickness(solids);
      CheckLooks(body);
      if (solids.parts.empty() || !(solids.mass > 0)) continue;
      CheckDensity(body, solids);
      CheckInertia(body);
      const std::vector<PlacedPart> placed = Placed(solids.parts);
      CheckCenter(body, placed);
      twice += CheckOverlap(body, solids, placed);
      CheckLoose(body, placed);
    }
    const double mass = object_.mass_properties.mass;
    return mass > 0 ? twice / mass : 0;
  }

 private:
  void CheckWhole() {
    const model::Box3& box = object_.bounds.aabb;
    const double mass = object_.mass_properties.mass;
    if (box.empty() || !(mass > 0)) return;
    const Eigen::Vector3d sides = box.max - box.min;
    if (!(sides.prod() > 0)) return;
    const double density = mass / sides.prod();
    if (!IsOutside(density, reporter_.checks().bulk_density)) return;
    reporter_.Warning(
        Code::kPhysicsBulkDensity, mark_,
        fmt::format("{} kg in a box of {} x {} x {} m is {}", RoundedText(mass),
                    RoundedText(sides.x()), RoundedText(sides.y()), RoundedText(sides.z()),
                    OutsideOf(density, reporter_.checks().bulk_density, "kg/m^3")),
        "sizes are in metres, masses in kilograms");
  }

  std::string_view OwnName(const model::Part& part) const {
    return model::OwnName(part.NameInSpec(), object_.name);
  }

  bool IsNamed(const model::Part& part, std::string_view name) const {
    return name == OwnName(part) || name == part.NameInSpec();
  }

  bool HasPart(std::string_view name) const {
    return std::ranges::any_of(object_.bodies, [&](const model::Body& body) {
      return std::ranges::any_of(body.parts,
                                 [&](const model::Part& part) { return IsNamed(part, name); });
    });
  }

  /// Reports names in checks.parts that no part has.
  void CheckPartNames() {
    for (const model::PartCheck& check : reporter_.checks().parts) {
      for (const std::string& name : check.parts) {
        if (HasPart(name)) continue;
        std::vector<std::string_view> known;
        for (const model::Body& body : object_.bodies) {
          for (const model::Part& part : body.parts) known.push_back(OwnName(part));
        }
        reporter_.Error(Code::kModelUnknownReference, check.mark,
                        fmt::format("`parts`: the object has no part '{}'", name),
                        diag::DidYouMean(name, known));
      }
    }
  }

  /// Returns the limit `own` of the first entry of `checks.parts` that names the part and sets this
  /// limit; `usual` if there is no such entry.
  template <typename T>
  T Limit(const model::Part& part, std::optional<T> model::PartCheck::*own, const T& usual) const {
    for (const model::PartCheck& check : reporter_.checks().parts) {
      const bool applies = std::ranges::any_of(
          check.parts, [&](const std::string& name) { return IsNamed(part, name); });
      if (applies && check.*own) return *(check.*own);
    }
    return usual;
  }

  void CheckThickness(const SolidParts& solids) {
    const model::Checks& checks = reporter_.checks();
    std::set<std::string_view> thin;
    for (const model::Part& solid : solids.parts) {
      const Eigen::Vector2d sides = SidesOf(solid.shape);
      // Reports only one thin piece of each shape.
      const bool is_reported = !solid.piece_of.empty() && thin.contains(solid.piece_of);
      const double thickness = Limit(solid, &model::PartCheck::thickness, checks.thickness);
      if (sides.x() < thickness && !is_reported) {
        thin.insert(solid.piece_of);
        const ExceededLimit beyond(1000 * sides.x(), 1000 * thickness);
        reporter_.Warning(Code::kPhysicsThin, solid.mark,
                          fmt::format("part '{}' is {} mm thin, less than {} mm",
                                      solid.NameInSpec(), beyond.value, beyond.limit),
                          "contacts push through thin parts; make it thicker, or set `role: "
                          "visual`");
      }
      const double aspect = Limit(solid, &model::PartCheck::aspect, checks.aspect);
      if (solid.piece_of.empty() && sides.y() > aspect * sides.x()) {
        const ExceededLimit beyond(sides.y() / sides.x(), aspect);
        reporter_.Warning(
            Code::kPhysicsSlender, solid.mark,
            fmt::format("part '{}' is {} times as long as it is thin, more than {} times",
                        solid.name, beyond.value, beyond.limit),
            "split it into several parts");
      }
    }
  }

  void CheckDensity(const model::Body& body, const SolidParts& solids) {
    const Eigen::Vector2d& usual = reporter_.checks().density;
    const auto check = [&](std::string_view what, const std::string& name, double mass,
                           double volume, const Eigen::Vector2d& range, diag::SourceMark mark) {
      if (!(mass > 0) || !(volume > 0) || !IsOutside(mass / volume, range)) return;
      reporter_.Warning(Code::kPhysicsDensity, mark,
                        fmt::format("{} '{}' has a density of {}", what, name,
                                    OutsideOf(mass / volume, range, "kg/m^3")),
                        range != usual              ? ""
                        : mass / volume < range.x() ? "polystyrene foam has about 20 kg/m^3"
                                                    : "osmium has 22,590 kg/m^3");
    };
    if (!solids.masses_known) {
      double volume = 0;
      for (const model::Part& solid : solids.parts) volume += model::Volume(solid.shape);
      check("body", body.name, solids.mass, volume, usual, body.mark);
      return;
    }
    for (const model::Part& solid : solids.parts) {
      if (solid.is_shell) continue;
      check("part", solid.NameInSpec(), solid.mass, model::Volume(solid.shape),
            Limit(solid, &model::PartCheck::density, usual), solid.mark);
    }
  }

  // Reports inertias that no solid can have. MuJoCo also rejects such inertias, unless the compiler
  // options balanceinertia or boundinertia change them.
  void CheckInertia(const model::Body& body) {
    // Eigenvalues in increasing order.
    const Eigen::Vector3d inertia = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                        body.mass_properties.I_Cm_F, Eigen::EigenvaluesOnly)
                                        .eigenvalues();
    const double rounding = kRounding * inertia.z();
    if (inertia.x() > kNothing * inertia.z() && inertia.x() + inertia.y() >= inertia.z() - rounding)
      return;
    reporter_.Error(
        Code::kPhysicsInertia, body.mark,
        fmt::format("body '{}' has principal inertias {:.4g}, {:.4g} and {:.4g} kg m^2, "
                    "which no solid can have",
                    body.name, inertia.x(), inertia.y(), inertia.z()),
        "each must be above 0 and at most the sum of the other two");
  }

  void CheckCenter(const model::Body& body, const std::vector<PlacedPart>& placed) {
    const Eigen::Vector3d& p_BCm = body.mass_properties.p_FCm;
    const std::vector<distance::PlacedShape> shapes(placed.begin(), placed.end());
    const double size = distance::BoxAround(shapes).diagonal().norm();
    if (distance::FromHull(shapes, p_BCm).norm() <= kHullTolerance * size) return;
    reporter_.Warning(
        Code::kPhysicsCenterOfMass, body.mark,
        fmt::format("the centre of mass of body '{}', {:.4g} {:.4g} {:.4g}, is outside "
                    "the hull of its parts",
                    body.name, p_BCm.x(), p_BCm.y(), p_BCm.z()));
  }

  /// Warns of parts of the body that overlap too much. Returns the mass that is counted twice, kg.
  /// Skips the check and returns 0 if the finding is silenced.
  double CheckOverlap(const model::Body& body, const SolidParts& solids,
                      const std::vector<PlacedPart>& placed) {
    if (reporter_.IsSilenced(Code::kPhysicsOverlap)) return 0;
    const Overlap overlap = FindOverlap(placed);
    const double share = overlap.mass / solids.mass;
    if (share > reporter_.checks().overlap) {
      reporter_.Warning(
          Code::kPhysicsOverlap, solids.parts[overlap.second].mark,
          fmt::format("{:.2g} % of the mass of body '{}' is counted twice, most of it where part "
                      "'{}' is inside part '{}'",
                      100 * share, body.name, solids.parts[overlap.second].NameInSpec(),
                      solids.parts[overlap.first].NameInSpec()),
          "make them meet at their faces, or lower a density");
    }
    return overlap.mass;
  }

  void CheckLoose(const model::Body& body, const std::vector<PlacedPart>& placed) {
    const double gap = reporter_.checks().gap;
    const std::vector<PartGroup> groups = ConnectedGroups(placed, gap);
    for (std::size_t i = 1; i < groups.size(); ++i) {
      const model::Part& loose = *placed[groups[i].front()].part;
      const NearestPart nearest = NearestOutside(placed, groups[i]);
      const ExceededLimit distance(1000 * nearest.distance, 1000 * gap);
      reporter_.Warning(
          Code::kPhysicsLoose, loose.mark,
          fmt::format("part '{}'{} of body '{}' is loose: {} mm from the nearest other part, '{}', "
                      "more than {} mm",
                      loose.NameInSpec(), WithMore(groups[i].size() - 1), body.name, distance.value,
                      placed[nearest.index].part->NameInSpec(), distance.limit));
    }
  }

  /// Compares visual with colliding parts of a body, by their bounding boxes.
  void CheckLooks(const model::Body& body) {
    std::vector<Box> hard;
    std::vector<Box> seen;
    Box all_hard;
    Box all_seen;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual) all_hard.extend(hard.emplace_back(BoxOf(part)));
      if (IsSeen(part)) all_seen.extend(seen.emplace_back(BoxOf(part)));
    }
    if (hard.empty()) return;
    const double size = all_hard.diagonal().norm();
    const bool is_reported = CheckVisuals(body, hard, size) + CheckUnseen(body, seen) > 0;
    if (!is_reported && !seen.empty()) CompareBoxes(body, all_hard, all_seen);
  }

  /// Reports visual parts far from all colliding parts; returns their number.
  std::size_t CheckVisuals(const model::Body& body, const std::vector<Box>& hard, double size) {
    std::size_t far = 0;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual) continue;
      const double distance = DistanceTo(hard, BoxOf(part));
      if (!(distance > kFar * size)) continue;
      ++far;
      reporter_.Warning(
          Code::kPhysicsFarVisual, part.mark,
          fmt::format("visual part '{}' is {} mm from all that collides of body '{}', which is "
                      "{} mm across",
                      part.name, RoundedText(1000 * distance), body.name, RoundedText(1000 * size)),
          "check its `pos` and its units; what is seen there can be neither touched nor held");
    }
    return far;
  }

  /// Reports colliding parts at places where nothing is visible; returns their number.
  std::size_t CheckUnseen(const model::Body& body, const std::vector<Box>& seen) {
    std::vector<const model::Part*> unseen;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual && !IsSeen(part) && !Overlaps(seen, BoxOf(part)))
        unseen.push_back(&part);
    }
    if (unseen.empty()) return 0;
    reporter_.Warning(Code::kPhysicsUnseen, unseen.front()->mark,
                      fmt::format("part '{}'{} of body '{}' collides where nothing is seen",
                                  unseen.front()->name, WithMore(unseen.size() - 1), body.name),
                      "a visual part there, or `role: both`");
    return unseen.size();
  }

  void CompareBoxes(const model::Body& body, const Box& hard, const Box& seen) {
    const double size = hard.diagonal().norm();
    const double beyond =
        std::max({(hard.min() - seen.min()).maxCoeff(), (seen.max() - hard.max()).maxCoeff(), 0.0});
    const double within =
        std::max({(seen.min() - hard.min()).maxCoeff(), (hard.max() - seen.max()).maxCoeff(), 0.0});
    const double most = reporter_.checks().look * size;
    const double farthest = std::max(beyond, within);
    if (!(farthest > most)) return;
    const ExceededLimit compared(1000 * farthest, 1000 * most);
    reporter_.Warning(
        Code::kPhysicsLooksDiffer, body.mark,
        fmt::format("what {} of body '{}' reaches {} mm beyond what {}, more than {} mm",
                    beyond > within ? "is seen" : "collides", body.name, compared.value,
                    beyond > within ? "collides" : "is seen", compared.limit),
        "the same sizes and places for both, or set `look`");
  }

  const model::Object& object_;
  diag::SourceMark mark_;
  Reporter& reporter_;
};

}  // namespace

double CheckProportions(const model::Object& object, diag::SourceMark mark, Reporter& reporter) {
  return Proportions(object, mark, reporter).Check();
}

}  // namespace mjforge::static_checks
