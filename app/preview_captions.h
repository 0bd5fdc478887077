// Captions of the variants on a contact sheet.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mjforge/manifest/manifest.h"
#include "mjforge/spec/spec.h"

namespace mjforge::app {

/// Returns the caption lines of each variant: its index, and the parameters that differ most
/// visibly between these variants (words first, then sizes). Only drawn parameters are used, unless
/// the spec has none. `width`: that of a tile, pixels.
std::vector<std::vector<std::string>> MakeCaptions(std::span<const manifest::Record> records,
                                                   const spec::ObjectSpec& spec, int width);

}  // namespace mjforge::app
