// Steps that adapt an object to its target: the host, which is the program that loads the MJCF
// file. Each step reads its own fields of TargetRules, and changes nothing if these require no
// change.
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
/// Reports as errors names of elements that the host uses itself, or to which the host gives a
/// special meaning because of their prefix or suffix.
void CheckNames(const model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_geoms.cc
/// Sets groups of parts, drops densities and margins, and splits parts that both collide and are
/// visible, each if the host requires this.
void AdaptGeoms(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_start.cc
/// Makes the object's start state its zero configuration (qpos0) if the spec or the target requires
/// this. Drops start positions and velocities if the host does not read keyframes, or needs none
/// because qpos0 describes the whole start.
void AdaptStart(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_bodies.cc
/// Adds bodies, sites and geoms that the host requires. Drops the root's free joint if the host
/// adds one itself, and cameras and lights that target the root if the host renames the root.
void AdaptBodies(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_shapes.cc
/// Replaces colliding cylinders and ellipsoids by convex meshes if the host cannot collide these
/// shapes with boxes and meshes.
void AdaptShapes(model::Object& object, const TargetRules& rules, diag::Findings& findings);

// adapt_sections.cc
/// Drops sections, elements and texture files that the host does not support.
void AdaptSections(model::Object& object, const TargetRules& rules, diag::Findings& findings);

}  // namespace mjforge::mjcf
