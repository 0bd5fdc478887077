// Detents: joints that snap to either end of their range.

#pragma once

#include "mjforge/assemble/field_reader.h"

namespace mjforge::assemble {

/// Makes a joint with a range snap to its ends: sets the attributes of a spring that pushes the
/// joint away from the dead centre, and of limits that bear the spring's force. Does nothing if the
/// entry has no `detent:`. Returns false after a finding.
bool ReadDetent(FieldReader& reader, const spec::Entry& entry, model::Joint& joint);

}  // namespace mjforge::assemble
