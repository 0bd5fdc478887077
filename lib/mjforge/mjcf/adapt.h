#pragma once

// The steps of fitting an object to its target. Each reads its own columns of the target's row and
// does nothing if they require nothing.

#include <span>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/targets.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// "a, b, c", at most five of them, "and 3 more".
std::string Listed(std::span<const std::string_view> names);

// adapt_names.cc
/// Names that would clash with the host's, as errors.
void CheckNames(const model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_geoms.cc
/// Groups, looks, densities and margins of parts.
void AdaptGeoms(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_bodies.cc
/// Bodies, joints and geoms around the object; what the host adds by itself.
void AdaptBodies(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_shapes.cc
/// Convex meshes in place of round shapes that do not collide with everything.
void AdaptShapes(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_sections.cc
/// Sections, elements and textures that the host does not take.
void AdaptSections(model::Object& object, const TargetRules& rules, diag::Findings& findings);

}  // namespace mjforge::mjcf
