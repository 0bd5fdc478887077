// Detents: joints that snap to the ends of their range, such as the rocker of a switch.

#pragma once

#include "mjforge/assemble/field_reader.h"

namespace mjforge::assemble {

/// Reads `detent:`, which makes a joint with a range snap to its ends. Sets the attributes of a
/// spring with negative stiffness, which pushes the joint away from its dead centre, and of limits
/// that withstand the spring. Changes nothing if the entry has no `detent:`. Returns false after
/// adding a finding.
bool ReadDetent(FieldReader& reader, const spec::Entry& entry, model::Joint& joint);

}  // namespace mjforge::assemble
