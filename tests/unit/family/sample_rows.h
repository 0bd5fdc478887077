// Variants of a small family, made by hand.

#pragma once

#include <string>

#include "mjforge/family/family.h"

namespace mjforge::family::sample_rows {

/// Returns the numbers of a variant with one body, a ball of this radius, and materials.
Numbers Ball(double radius, const std::string& material, double red, double shift = 0);

/// Base MJCF of these variants.
extern const char* const kBase;

}  // namespace mjforge::family::sample_rows
