// Compares the masses and shapes that this MuJoCo and later releases compute from the same file.
#include "mjforge/validate/release_differences.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"

namespace mjforge::validate {
namespace {

using diag::Code;

constexpr double kAgreement = 1e-6;  // largest relative difference of equal numbers
constexpr const char* kMassHint = "an `<inertial>` in each body with meshes makes them agree";

/// Describes the first body whose mass differs between `m` (later releases) and `here` (this
/// MuJoCo); empty if there is none.
std::string OtherMass(const mjModel& m, const mjModel& here) {
  std::vector<int> bodies;
  for (int i = 1; i < m.nbody; ++i) {
    if (std::abs(here.body_mass[i] - m.body_mass[i]) > kAgreement * m.body_mass[i])
      bodies.push_back(i);
  }
  if (bodies.empty()) return {};
  const int first = bodies.front();
  std::string message =
      fmt::format("MuJoCo {} computes a mass of {:.6g} kg for body '{}', later releases {:.6g} kg",
                  engine::Version(), here.body_mass[first], compiled::NameOf(m, mjOBJ_BODY, first),
                  m.body_mass[first]);
  if (bodies.size() > 1)
    message += fmt::format("; {} of {} bodies differ", bodies.size(), m.nbody - 1);
  return message;
}

/// Describes the first geom whose size or position differs between `m` (later releases) and `here`
/// (this MuJoCo); empty if there is none.
std::string OtherShape(const mjModel& m, const mjModel& here) {
  const auto differ = [](const mjtNum* a, const mjtNum* b, double scale) {
    return mju_dist3(a, b) > kAgreement * scale;
  };
  const auto place = [](const mjModel& model, int geom) {
    const mjtNum* size = model.geom_size + 3 * geom;
    const mjtNum* pos = model.geom_pos + 3 * geom;
    return fmt::format("size {:.4g} {:.4g} {:.4g} at {:.4g} {:.4g} {:.4g}", size[0], size[1],
                       size[2], pos[0], pos[1], pos[2]);
  };
  for (int i = 0; i < m.ngeom; ++i) {
    const double scale = mju_norm3(m.geom_size + 3 * i);
    if (!differ(m.geom_size + 3 * i, here.geom_size + 3 * i, scale) &&
        !differ(m.geom_pos + 3 * i, here.geom_pos + 3 * i, scale))
      continue;
    return fmt::format("MuJoCo {} fits geom '{}' to its mesh with {}, later releases with {}",
                       engine::Version(), compiled::NameOf(m, mjOBJ_GEOM, i), place(here, i),
                       place(m, i));
  }
  return {};
}

}  // namespace

void CompareReleases(const mjModel& m, const engine::Loaded& as_is,
                     const backport::RuleDifferences& places, diag::Findings& findings) {
  if (!as_is.model) {
    findings.Warn(Code::kMujocoOlder,
                  places.visible ? places.visible
                  : places.mass  ? places.mass
                                 : places.fitted,
                  fmt::format("MuJoCo {} rejects the model: {}", engine::Version(),
                              engine::ParseRefusal(as_is.error).reason),
                  places.visible ? "without `discardvisual` it accepts the model" : kMassHint);
    return;
  }
  const mjModel& here = *as_is.model;
  if (here.nbody != m.nbody) return;
  std::string mass = OtherMass(m, here);
  std::string shape;
  if (places.fitted && here.ngeom == m.ngeom) shape = OtherShape(m, here);
  if (shape.empty()) {
    if (!mass.empty()) findings.Warn(Code::kMujocoOlder, places.mass, std::move(mass), kMassHint);
    return;
  }
  diag::Finding& finding =
      findings.Warn(Code::kMujocoOlder, places.fitted, std::move(shape),
                    "a `size`, `pos` and `quat` in place of the geom's `mesh` makes them agree");
  if (!mass.empty()) finding.notes.push_back({places.mass, std::move(mass)});
}

}  // namespace mjforge::validate
