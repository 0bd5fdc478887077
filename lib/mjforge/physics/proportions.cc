#include "mjforge/physics/proportions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjforge/physics/overlap.h"
#include "mjforge/physics/touching.h"

namespace mjforge::physics {
namespace {

using diag::Code;

// A sum of finite numbers of inertia: rounding of the principal axes.
constexpr double kRounding = 1e-6;

std::string OutsideOf(double value, const Eigen::Vector2d& range, std::string_view unit) {
  const bool low = value < range.x();
  return fmt::format("{:.3g} {}, {} than {:g}", value, unit, low ? "less" : "more",
                     low ? range.x() : range.y());
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

class Proportions {
 public:
  Proportions(const Subject& subject, Verdict& verdict) : subject_(subject), verdict_(verdict) {}

  double Check() {
    CheckWhole();
    double twice = 0;
    for (const RigidBody& body : subject_.bodies) {
      CheckSolids(body);
      if (!(body.mass > 0)) continue;
      CheckDensity(body);
      CheckInertia(body);
      CheckCenter(body);
      twice += CheckOverlap(body);
      CheckPieces(body);
    }
    return subject_.mass > 0 ? twice / subject_.mass : 0;
  }

 private:
  void CheckWhole() {
    if (subject_.box.empty() || !(subject_.mass > 0)) return;
    const double volume = (subject_.box.max - subject_.box.min).prod();
    if (!(volume > 0)) return;
    const double density = subject_.mass / volume;
    if (!IsOutside(density, verdict_.checks().bulk_density)) return;
    verdict_.Warning(Code::kPhysicsBulkDensity, subject_.mark,
                     fmt::format("{:.3g} kg in a box of {:.3g} x {:.3g} x {:.3g} m is {}",
                                 subject_.mass, subject_.box.max.x() - subject_.box.min.x(),
                                 subject_.box.max.y() - subject_.box.min.y(),
                                 subject_.box.max.z() - subject_.box.min.z(),
                                 OutsideOf(density, verdict_.checks().bulk_density, "kg/m^3")),
                     "sizes are in metres, masses in kilograms");
  }

  void CheckSolids(const RigidBody& body) {
    const model::Checks& checks = verdict_.checks();
    for (const Solid& solid : body.solids) {
      const Eigen::Vector2d sides = SidesOf(solid.shape);
      if (sides.x() < checks.thickness) {
        verdict_.Warning(Code::kPhysicsThin, solid.mark,
                         fmt::format("part '{}' is {:.3g} mm thin, less than {:g} mm", solid.name,
                                     1000 * sides.x(), 1000 * checks.thickness),
                         "contacts push through thin parts; give it more, or `role: visual`");
      }
      if (sides.y() > checks.aspect * sides.x()) {
        verdict_.Warning(
            Code::kPhysicsSlender, solid.mark,
            fmt::format("part '{}' is {:.3g} times as long as it is thin, more than {:g} times",
                        solid.name, sides.y() / sides.x(), checks.aspect),
            "split it into several parts");
      }
    }
  }

  void CheckDensity(const RigidBody& body) {
    const Eigen::Vector2d& range = verdict_.checks().density;
    const auto check = [&](std::string_view what, const std::string& name, double mass,
                           double volume, diag::SourceMark mark) {
      if (!(mass > 0) || !(volume > 0) || !IsOutside(mass / volume, range)) return;
      verdict_.Warning(Code::kPhysicsDensity, mark,
                       fmt::format("{} '{}' has a density of {}", what, name,
                                   OutsideOf(mass / volume, range, "kg/m^3")),
                       mass / volume < range.x() ? "polystyrene foam has about 20 kg/m^3"
                                                 : "osmium has 22,590 kg/m^3");
    };
    if (!body.masses_known) {
      double volume = 0;
      for (const Solid& solid : body.solids) volume += model::Volume(solid.shape);
      check("body", body.name, body.mass, volume, body.mark);
      return;
    }
    for (const Solid& solid : body.solids)
      check("part", solid.name, solid.mass, model::Volume(solid.shape), solid.mark);
  }

  // MuJoCo refuses such inertias too, unless it is told to balance or bound them.
  void CheckInertia(const RigidBody& body) {
    Eigen::Vector3d inertia = body.inertia;
    std::sort(inertia.begin(), inertia.end());
    const double rounding = kRounding * inertia.z();
    if (inertia.x() > 0 && inertia.x() + inertia.y() >= inertia.z() - rounding) return;
    verdict_.Error(Code::kPhysicsInertia, body.mark,
                   fmt::format("body '{}' has principal inertias {:.4g}, {:.4g} and {:.4g} kg m^2, "
                               "which no solid has",
                               body.name, inertia.x(), inertia.y(), inertia.z()),
                   "each is above 0, and no more than the other two together");
  }

  void CheckCenter(const RigidBody& body) {
    if (CenterOfMassIsInside(body)) return;
    verdict_.Warning(
        Code::kPhysicsCenterOfMass, body.mark,
        fmt::format("the centre of mass of body '{}', {:.4g} {:.4g} {:.4g}, is outside "
                    "the hull of its parts",
                    body.name, body.p_BCm.x(), body.p_BCm.y(), body.p_BCm.z()));
  }

  /// kg counted twice.
  double CheckOverlap(const RigidBody& body) {
    const Overlap overlap = FindOverlap(body);
    const double share = overlap.mass / body.mass;
    if (share > verdict_.checks().overlap) {
      verdict_.Warning(
          Code::kPhysicsOverlap, body.solids[overlap.second].mark,
          fmt::format("{:.2g} % of the mass of body '{}' is counted twice, most of it where part "
                      "'{}' is inside part '{}'",
                      100 * share, body.name, body.solids[overlap.second].name,
                      body.solids[overlap.first].name),
          "make them meet at their faces, or lower a density");
    }
    return overlap.mass;
  }

  void CheckPieces(const RigidBody& body) {
    if (body.solids.size() < 2) return;
    const double gap = verdict_.checks().gap;
    const auto pieces = Pieces(body, gap);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      const Solid& solid = body.solids[pieces[i].front()];
      const std::size_t more = pieces[i].size() - 1;
      verdict_.Warning(
          Code::kPhysicsLoose, solid.mark,
          fmt::format("part '{}'{} of body '{}' touches nothing else of it within {:g} mm",
                      solid.name, more > 0 ? fmt::format(" with {} more", more) : "", body.name,
                      1000 * gap));
    }
  }

  const Subject& subject_;
  Verdict& verdict_;
};

}  // namespace

double CheckProportions(const Subject& subject, Verdict& verdict) {
  return Proportions(subject, verdict).Check();
}

}  // namespace mjforge::physics
