// Makes the first variants of a recipe for fuzzing, in a batch and alone.

#pragma once

#include "fuzz/input.h"
#include "mjforge/forge/forge.h"

namespace mjforge::fuzz {

/// Makes the first variants of a recipe, by one generator and each by a generator of its own,
/// without loading them in MuJoCo. Both must give the same bytes, the files must be MJCF, and the
/// records must be read back.
void MakeVariants(const forge::Recipe& recipe, diag::Sources& sources, forge::Options options);

}  // namespace mjforge::fuzz
