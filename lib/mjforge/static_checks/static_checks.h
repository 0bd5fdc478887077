// Checks of an object's numbers that need no simulation: the expectations of its spec, and its
// proportions compared with those of real things.
#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"
#include "mjforge/static_checks/reporter.h"

namespace mjforge::static_checks {

/// Adds an error, with the required and the actual number, for each of object.expectations that
/// does not hold. Also adds the findings of object.unmet_expectations. Shapes are exact, except
/// that a mesh counts as its convex hull. Visual parts count only for bodies without colliding
/// parts.
void CheckExpectations(const model::Object& object, diag::Findings& findings);

/// Checks densities, sizes, inertias and centres of mass, overlapping and loose parts, and
/// differences between visual and colliding parts. Returns the share of the object's mass that is
/// counted twice because parts overlap. Findings about the whole object refer to `mark`.
double CheckProportions(const model::Object& object, diag::SourceMark mark, Reporter& reporter);

/// Warns of parts that should collide but have contact bits of zero, and of contact margins that
/// keep other things visibly away from a part.
void CheckContacts(const model::Object& object, Reporter& reporter);

}  // namespace mjforge::static_checks
