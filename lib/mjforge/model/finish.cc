// What follows from the parts: bounds, mass, and whether the object can exist.

#include <fmt/format.h>

#include "mjforge/model/assembly.h"
#include "mjforge/model/names.h"

namespace mjforge::model {
namespace {

using diag::Code;

// MuJoCo's mjMINVAL, the smallest mass of a body that moves.
constexpr double kSmallestMass = 1e-15;

Bounds DeclaredBounds(const Eigen::Vector3d& total_size) {
  Bounds bounds;
  bounds.aabb = {.min = -total_size, .max = total_size};
  bounds.top_offset = total_size.z();
  bounds.bottom_offset = -total_size.z();
  bounds.horizontal_radius = total_size.head<2>().norm();
  return bounds;
}

}  // namespace

Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first) {
  bool some_collide = false;
  for (std::size_t i = first; i < parts.size(); ++i) {
    some_collide |= parts[i].role != Role::kVisual;
  }
  Bounds bounds;
  for (std::size_t i = first; i < parts.size(); ++i) {
    const Part& part = parts[i];
    if (some_collide && part.role == Role::kVisual) continue;
    bounds.aabb.Add(BoundsOf(part.shape, part.X_BG));
    bounds.horizontal_radius =
        std::max(bounds.horizontal_radius, HorizontalRadius(part.shape, part.X_BG));
  }
  if (bounds.aabb.empty()) return bounds;
  bounds.top_offset = bounds.aabb.max.z();
  bounds.bottom_offset = bounds.aabb.min.z();
  return bounds;
}

MassProperties Assembly::MassOfBody() {
  MassProperties sum;
  for (const Part& part : body().parts) {
    if (!(part.mass > 0)) continue;
    MassProperties properties = *assets_.UnitMassOf(part.shape, part.mesh);
    properties.I_Cm_F *= part.mass / properties.mass;
    properties.mass = part.mass;
    sum = Combine(sum, InFrame(part.X_BG, properties));
    body().explicit_inertial |= part.shape.type == GeomType::kMesh;
  }
  return sum;
}

void Assembly::Finish(const Scope& scope) {
  const std::vector<spec::Entry>& entries = scope.values.spec().parts;
  if (body().parts.empty()) {
    findings_.Add(Code::kModelNoParts, entries.empty() ? diag::SourceMark() : entries.front().mark,
                  "no part is left", "the 'if' or 'for' of every part leaves it out");
    return;
  }
  CheckUniqueNames(object_, findings_);
  body().mass_properties = MassOfBody();
  object_.mass_properties = body().mass_properties;
  if (!body().joints.empty() && !(body().mass_properties.mass > kSmallestMass)) {
    findings_.Add(Code::kModelNoMass, body().mark,
                  fmt::format("object '{}' can move but has no mass", object_.name),
                  "give a part a mass, or write `joints: none`");
  }
  object_.bounds = scope.total_size ? DeclaredBounds(*scope.total_size) : BoundsOf(body().parts);
}

}  // namespace mjforge::model
