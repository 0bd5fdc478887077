// Steps of adapting an object to its target, the host program that loads the file. Each step reads
// its own fields of TargetRules, and changes nothing if these fields require no change.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/targets.h"
#include "mjforge/model/model.h"

namespace mjforge::mjcf {

/// Joins names for a message. Lists at most five names: "a, b, c, d, e and 3 more".
std::string JoinNames(std::span<const std::string_view> names);

// adapt_names.cc
/// Reports names of elements that the host program uses itself, or to which it gives a special
/// meaning by a prefix or suffix.
void CheckNames(const model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_geoms.cc
/// Adapts groups, colors, densities and margins of parts.
void AdaptGeoms(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_start.cc
/// Moves the zero configuration (qpos0) to the start state of the object if the spec or the target
/// requires this. Drops start positions and velocities if the host reads or needs no keyframe.
void AdaptStart(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_bodies.cc
/// Adds bodies, sites and geoms that the host requires; drops joints that the host adds itself.
void AdaptBodies(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_shapes.cc
/// Replaces colliding cylinders and ellipsoids by convex meshes if the host cannot collide these
/// shapes with boxes and meshes.
void AdaptShapes(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_sections.cc
/// Drops sections, elements and texture files that the host does not support.
void AdaptSections(model::Object& object, const TargetRules& rules, diag::Findings& findings);

}  // namespace mjforge::mjcf
