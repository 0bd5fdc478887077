// Selection of a body's solid parts and computation of their masses: as stated in the spec, shared
// among the pieces of a shape, or in proportion to volume.
#include "mjforge/static_checks/solid_parts.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace mjforge::static_checks {
namespace {

/// Gives each piece of a shape a share of the shape's mass, in proportion to the piece's volume.
void ShareMasses(const model::Body& body, std::vector<model::Part>& parts) {
  std::map<std::string_view, double> volumes;
  for (const model::Part& part : parts) {
    if (!part.piece_of.empty()) volumes[part.piece_of] += model::Volume(part.shape);
  }
  if (volumes.empty()) return;
  // The mass of a shape is that of one of its parts: of the visual part or, without a visual part,
  // of one of the convex pieces. The sum over all parts finds this mass in both cases.
  std::map<std::string_view, double> masses;
  for (const model::Part& part : body.parts) masses[part.NameInSpec()] += part.mass;
  for (model::Part& part : parts) {
    if (part.piece_of.empty()) continue;
    part.mass = masses[part.piece_of] * model::Volume(part.shape) / volumes[part.piece_of];
  }
}

}  // namespace

SolidParts SolidPartsOf(const model::Body& body) {
  const auto collides = [](const model::Part& part) { return part.role != model::Role::kVisual; };
  SolidParts solids = {.parts = body.parts};
  if (std::ranges::any_of(body.parts, collides)) {
    std::erase_if(solids.parts, [&](const model::Part& part) { return !collides(part); });
  }
  ShareMasses(body, solids.parts);
  double volume = 0;
  for (const model::Part& part : solids.parts) {
    solids.mass += part.mass;
    volume += model::Volume(part.shape);
  }
  solids.masses_known = solids.mass > 0;
  if (solids.masses_known) return solids;
  solids.mass = body.mass_properties.mass;
  // Assumes that all parts have the same density.
  for (model::Part& part : solids.parts) {
    part.mass = volume > 0 ? solids.mass * model::Volume(part.shape) / volume : 0;
  }
  return solids;
}

}  // namespace mjforge::static_checks
