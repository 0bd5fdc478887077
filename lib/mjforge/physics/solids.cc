#include "mjforge/physics/solids.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace mjforge::physics {

namespace {

/// Pieces of a shape have its mass by their volumes.
void ShareMasses(const model::Body& body, std::vector<model::Part>& parts) {
  std::map<std::string_view, double> volumes;
  for (const model::Part& part : parts) {
    if (!part.piece_of.empty()) volumes[part.piece_of] += model::Volume(part.shape);
  }
  if (volumes.empty()) return;
  std::map<std::string_view, double> masses;  // what is seen has it, or one of the pieces
  for (const model::Part& part : body.parts)
    masses[part.piece_of.empty() ? part.name : part.piece_of] += part.mass;
  for (model::Part& part : parts) {
    if (part.piece_of.empty()) continue;
    part.mass = masses[part.piece_of] * model::Volume(part.shape) / volumes[part.piece_of];
  }
}

}  // namespace

Solids SolidsOf(const model::Body& body) {
  const auto collides = [](const model::Part& part) { return part.role != model::Role::kVisual; };
  Solids solids = {.parts = body.parts};
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
  // As if all were of one stuff.
  for (model::Part& part : solids.parts) {
    const double mass_volume = solids.mass * model::Volume(part.shape);
    part.mass = volume > 0 ? mass_volume / volume : 0;
  }
  return solids;
}

std::vector<model::Box3> BoxesOf(const std::vector<model::Part>& parts) {
  std::vector<model::Box3> boxes;
  boxes.reserve(parts.size());
  for (const model::Part& part : parts) boxes.push_back(model::BoundsOf(part.shape, part.X_BG));
  return boxes;
}

}  // namespace mjforge::physics
