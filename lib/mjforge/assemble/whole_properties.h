// Properties that depend on all bodies of a spec: of subtrees, positions of sites, torques of
// joints.

#pragma once

#include <cstddef>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Removes the values of `count` variables, starting with the variable at index `slot` of the
/// evaluator. Does nothing if `slot` is negative.
void ClearSlots(int slot, std::size_t count, sample::Evaluator& values);
/// Sets the variables from slot `slot` on to the properties of a body, in the order of
/// spec::BodyProperty. `mass` is in kg.
void SetMeasures(const model::Bounds& bounds, double mass, int slot, sample::Evaluator& values);

}  // namespace mjforge::assemble
