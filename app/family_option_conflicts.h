// Check of the options of `mjforge generate` against the rules for families (-o NAME.npz).

#pragma once

#include <string>

#include "mjforge/batch/batch.h"

namespace mjforge::app {

/// Returns the message for an option that a family of variants (`-o NAME.npz`) does not support, or
/// that only a family has; empty if there is none. `output` is the value of -o.
std::string FindFamilyConflict(const std::string& output, const batch::Request& request);

}  // namespace mjforge::app
