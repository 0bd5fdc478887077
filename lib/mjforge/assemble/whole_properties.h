// Variables of expressions that depend on all bodies of a spec: properties of subtrees, positions
// of sites, and torques of gravity on joints.

#pragma once

#include <cstddef>

#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Removes the values of `count` consecutive variables of the evaluator; `slot` is the index of the
/// first. Does nothing if `slot` is negative.
void ClearSlots(int slot, std::size_t count, sample::Evaluator& values);
/// Sets consecutive variables of the evaluator to the properties of a body, in the order of
/// spec::BodyProperty. `slot` is the index of the first variable, `mass` is in kg.
void SetMeasures(const model::Bounds& bounds, double mass, int slot, sample::Evaluator& values);

}  // namespace mjforge::assemble
