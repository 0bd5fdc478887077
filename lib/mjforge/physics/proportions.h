#pragma once

#include "mjforge/model/model.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Compares an object with real things: densities, sizes, inertias, parts that overlap or hang in
/// the air. Returns the share of the mass that is counted twice. `mark` is for what is of no single
/// body.
double CheckProportions(const model::Object& object, diag::SourceMark mark, Verdict& verdict);

}  // namespace mjforge::physics
