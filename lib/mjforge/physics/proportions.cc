#include "mjforge/physics/proportions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <vector>

#include "mjforge/physics/overlap.h"
#include "mjforge/physics/rounding.h"
#include "mjforge/physics/solids.h"
#include "mjforge/physics/touching.h"

namespace mjforge::physics {
namespace {

using diag::Code;

// A sum of finite numbers of inertia: rounding of the principal axes.
constexpr double kRounding = 1e-6;
constexpr double kNothing = 1e-12;
// A visual part farther than so many times the body's size is not part of how it looks.
constexpr double kFar = 0.5;
constexpr double kFaces = 1e-9;  // m

std::string OutsideOf(double value, const Eigen::Vector2d& range, std::string_view unit) {
  const bool low = value < range.x();
  const double limit = low ? range.x() : range.y();
  const Beyond beyond(value, limit);
  return fmt::format("{} {}, {} than {}", beyond.value, unit, low ? "less" : "more", beyond.limit);
}

bool IsOutside(double value, const Eigen::Vector2d& range) {
  return value < range.x() || value > range.y();
}

/// Shortest and longest side: of a mesh, of its box.
Eigen::Vector2d SidesOf(const model::Shape& shape) {
  const model::Box3 box = model::BoundsOf(shape, {});
  const Eigen::Vector3d sides = box.max - box.min;
  return {sides.minCoeff(), sides.maxCoeff()};
}

/// As the spec calls it.
const std::string& NameOf(const model::Part& part) {
  return part.piece_of.empty() ? part.name : part.piece_of;
}

std::string WithMore(std::size_t more) {
  return more > 0 ? fmt::format(" with {} more", more) : std::string();
}

/// A viewer shows groups 0 to 2; a part of a spec is seen by a geom of its own.
bool IsSeen(const model::Part& part) {
  if (!part.as_is) return part.role != model::Role::kCollision;
  const auto group = std::ranges::find(part.attributes, "group", &model::Attribute::name);
  return group == part.attributes.end() || group->numbers.empty() || group->numbers[0] <= 2;
}

using Box = Eigen::AlignedBox3d;

Box BoxAround(const model::Part& part) {
  const model::Box3 box = model::BoundsOf(part.shape, part.X_BG);
  return {box.min, box.max};
}

/// More than faces that meet.
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
  Proportions(const model::Object& object, diag::SourceMark mark, Verdict& verdict)
      : object_(object), mark_(mark), verdict_(verdict) {}

  double Check() {
    FindParts();
    CheckWhole();
    double twice = 0;
    for (const model::Body& body : object_.bodies) {
      const Solids solids = SolidsOf(body);
      CheckSolids(solids);
      CheckLooks(body);
      if (solids.parts.empty() || !(solids.mass > 0)) continue;
      CheckDensity(body, solids);
      CheckInertia(body);
      CheckCenter(body, solids);
      twice += CheckOverlap(body, solids);
      CheckPieces(body, solids);
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
    if (!IsOutside(density, verdict_.checks().bulk_density)) return;
    verdict_.Warning(
        Code::kPhysicsBulkDensity, mark_,
        fmt::format("{} kg in a box of {} x {} x {} m is {}", RoundedText(mass),
                    RoundedText(sides.x()), RoundedText(sides.y()), RoundedText(sides.z()),
                    OutsideOf(density, verdict_.checks().bulk_density, "kg/m^3")),
        "sizes are in metres, masses in kilograms");
  }

  /// Without the object's in front of it.
  std::string_view OwnName(const model::Part& part) const {
    std::string_view name = NameOf(part);
    if (name.starts_with(object_.name) && name.substr(object_.name.size()).starts_with('_'))
      name.remove_prefix(object_.name.size() + 1);
    return name;
  }

  bool IsNamed(const model::Part& part, std::string_view name) const {
    return name == OwnName(part) || name == NameOf(part);
  }

  bool HasPart(std::string_view name) const {
    return std::ranges::any_of(object_.bodies, [&](const model::Body& body) {
      return std::ranges::any_of(body.parts,
                                 [&](const model::Part& part) { return IsNamed(part, name); });
    });
  }

  /// Entries of checks.parts must be of parts that there are.
  void FindParts() {
    for (const model::PartCheck& check : verdict_.checks().parts) {
      for (const std::string& name : check.parts) {
        if (HasPart(name)) continue;
        std::vector<std::string_view> known;
        for (const model::Body& body : object_.bodies) {
          for (const model::Part& part : body.parts) known.push_back(OwnName(part));
        }
        verdict_.Error(Code::kModelUnknownReference, check.mark,
                       fmt::format("`parts`: the object has no part '{}'", name),
                       diag::DidYouMean(name, known));
      }
    }
  }

  /// What an entry of checks.parts says of a part, or else what holds for all.
  template <typename T>
  T Limit(const model::Part& part, std::optional<T> model::PartCheck::*own, const T& usual) const {
    for (const model::PartCheck& check : verdict_.checks().parts) {
      const bool speaks = std::ranges::any_of(
          check.parts, [&](const std::string& name) { return IsNamed(part, name); });
      if (speaks && check.*own) return *(check.*own);
    }
    return usual;
  }

  void CheckSolids(const Solids& solids) {
    const model::Checks& checks = verdict_.checks();
    std::set<std::string_view> thin;
    for (const model::Part& solid : solids.parts) {
      const Eigen::Vector2d sides = SidesOf(solid.shape);
      // One piece of a shape speaks for all.
      const bool is_told = !solid.piece_of.empty() && thin.contains(solid.piece_of);
      const double thickness = Limit(solid, &model::PartCheck::thickness, checks.thickness);
      if (sides.x() < thickness && !is_told) {
        thin.insert(solid.piece_of);
        const Beyond beyond(1000 * sides.x(), 1000 * thickness);
        verdict_.Warning(Code::kPhysicsThin, solid.mark,
                         fmt::format("part '{}' is {} mm thin, less than {} mm", NameOf(solid),
                                     beyond.value, beyond.limit),
                         "contacts push through thin parts; make it thicker, or set `role: "
                         "visual`");
      }
      const double aspect = Limit(solid, &model::PartCheck::aspect, checks.aspect);
      if (solid.piece_of.empty() && sides.y() > aspect * sides.x()) {
        const Beyond beyond(sides.y() / sides.x(), aspect);
        verdict_.Warning(
            Code::kPhysicsSlender, solid.mark,
            fmt::format("part '{}' is {} times as long as it is thin, more than {} times",
                        solid.name, beyond.value, beyond.limit),
            "split it into several parts");
      }
    }
  }

  void CheckDensity(const model::Body& body, const Solids& solids) {
    const Eigen::Vector2d& usual = verdict_.checks().density;
    const auto check = [&](std::string_view what, const std::string& name, double mass,
                           double volume, const Eigen::Vector2d& range, diag::SourceMark mark) {
      if (!(mass > 0) || !(volume > 0) || !IsOutside(mass / volume, range)) return;
      verdict_.Warning(Code::kPhysicsDensity, mark,
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
    for (const model::Part& solid : solids.parts)
      check("part", NameOf(solid), solid.mass, model::Volume(solid.shape),
            Limit(solid, &model::PartCheck::density, usual), solid.mark);
  }

  // MuJoCo refuses such inertias too, unless it is told to balance or bound them.
  void CheckInertia(const model::Body& body) {
    // Sorted.
    const Eigen::Vector3d inertia = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                        body.mass_properties.I_Cm_F, Eigen::EigenvaluesOnly)
                                        .eigenvalues();
    const double rounding = kRounding * inertia.z();
    if (inertia.x() > kNothing * inertia.z() && inertia.x() + inertia.y() >= inertia.z() - rounding)
      return;
    verdict_.Error(Code::kPhysicsInertia, body.mark,
                   fmt::format("body '{}' has principal inertias {:.4g}, {:.4g} and {:.4g} kg m^2, "
                               "which no solid can have",
                               body.name, inertia.x(), inertia.y(), inertia.z()),
                   "each must be above 0 and at most the sum of the other two");
  }

  void CheckCenter(const model::Body& body, const Solids& solids) {
    const Eigen::Vector3d& p_BCm = body.mass_properties.p_FCm;
    if (IsInsideHull(solids.parts, p_BCm)) return;
    verdict_.Warning(
        Code::kPhysicsCenterOfMass, body.mark,
        fmt::format("the centre of mass of body '{}', {:.4g} {:.4g} {:.4g}, is outside "
                    "the hull of its parts",
                    body.name, p_BCm.x(), p_BCm.y(), p_BCm.z()));
  }

  /// kg counted twice; not looked at where that does not matter.
  double CheckOverlap(const model::Body& body, const Solids& solids) {
    if (verdict_.IsSilenced(Code::kPhysicsOverlap)) return 0;
    const Overlap overlap = FindOverlap(solids.parts);
    const double share = overlap.mass / solids.mass;
    if (share > verdict_.checks().overlap) {
      verdict_.Warning(
          Code::kPhysicsOverlap, solids.parts[overlap.second].mark,
          fmt::format("{:.2g} % of the mass of body '{}' is counted twice, most of it where part "
                      "'{}' is inside part '{}'",
                      100 * share, body.name, NameOf(solids.parts[overlap.second]),
                      NameOf(solids.parts[overlap.first])),
          "make them meet at their faces, or lower a density");
    }
    return overlap.mass;
  }

  void CheckPieces(const model::Body& body, const Solids& solids) {
    if (solids.parts.size() < 2) return;
    const double gap = verdict_.checks().gap;
    const auto pieces = Pieces(solids.parts, gap);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const model::Part& solid = solids.parts[pieces[i].front()];
      const std::size_t more = pieces[i].size() - 1;
      const Neighbour nearest = NearestOf(solids.parts, pieces[i], gap);
      const Beyond beyond(1000 * nearest.distance, 1000 * gap);
      verdict_.Warning(
          Code::kPhysicsLoose, solid.mark,
          fmt::format("part '{}'{} of body '{}' is loose: {} mm from the nearest other part, '{}', "
                      "more than {} mm",
                      NameOf(solid), WithMore(more), body.name, beyond.value,
                      NameOf(solids.parts[nearest.part]), beyond.limit));
    }
  }

  /// How well what is seen of a body goes with what collides. Boxes tell.
  void CheckLooks(const model::Body& body) {
    std::vector<Box> hard;
    std::vector<Box> seen;
    Box all_hard;
    Box all_seen;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual) all_hard.extend(hard.emplace_back(BoxAround(part)));
      if (IsSeen(part)) all_seen.extend(seen.emplace_back(BoxAround(part)));
    }
    if (hard.empty()) return;
    const double size = all_hard.diagonal().norm();
    const bool is_told = CheckVisuals(body, hard, size) + CheckUnseen(body, seen) > 0;
    if (!is_told && !seen.empty()) CompareBoxes(body, all_hard, all_seen);
  }

  /// How many visual parts are far from all that collides.
  std::size_t CheckVisuals(const model::Body& body, const std::vector<Box>& hard, double size) {
    std::size_t far = 0;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual) continue;
      const double distance = DistanceTo(hard, BoxAround(part));
      if (!(distance > kFar * size)) continue;
      ++far;
      verdict_.Warning(
          Code::kPhysicsFarVisual, part.mark,
          fmt::format("visual part '{}' is {} mm from all that collides of body '{}', which is "
                      "{} mm across",
                      part.name, RoundedText(1000 * distance), body.name, RoundedText(1000 * size)),
          "check its `pos` and its units; what is seen there can be neither touched nor held");
    }
    return far;
  }

  /// How many parts collide where nothing is seen.
  std::size_t CheckUnseen(const model::Body& body, const std::vector<Box>& seen) {
    std::vector<const model::Part*> unseen;
    for (const model::Part& part : body.parts) {
      if (part.role != model::Role::kVisual && !IsSeen(part) && !Overlaps(seen, BoxAround(part)))
        unseen.push_back(&part);
    }
    if (unseen.empty()) return 0;
    verdict_.Warning(Code::kPhysicsUnseen, unseen.front()->mark,
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
    const double most = verdict_.checks().look * size;
    const double farthest = std::max(beyond, within);
    if (!(farthest > most)) return;
    const Beyond compared(1000 * farthest, 1000 * most);
    verdict_.Warning(
        Code::kPhysicsLooksDiffer, body.mark,
        fmt::format("what {} of body '{}' reaches {} mm beyond what {}, more than {} mm",
                    beyond > within ? "is seen" : "collides", body.name, compared.value,
                    beyond > within ? "collides" : "is seen", compared.limit),
        "the same sizes and places for both, or set `look`");
  }

  const model::Object& object_;
  diag::SourceMark mark_;
  Verdict& verdict_;
};

}  // namespace

double CheckProportions(const model::Object& object, diag::SourceMark mark, Verdict& verdict) {
  return Proportions(object, mark, verdict).Check();
}

}  // namespace mjforge::physics
