// Checks of the content of mesh and skin files, one function per format, and parsing of numbers.
#pragma once

#include <string_view>

#include "mjforge/mesh_data/mesh_data.h"

namespace mjforge::mesh_data {

/// Check the content of a file of one format; results as for CheckFile().
Check CheckObj(std::string_view content);
Check CheckStl(std::string_view content);
Check CheckMsh(std::string_view content);
Check CheckSkn(std::string_view content);

/// Returns true for numbers that remain finite when converted to float.
bool IsFiniteFloat(double number);

/// Parses a decimal integer, with or without a sign; returns nullopt for other words. Returns a
/// double, because an index in a file may exceed the range of int.
std::optional<double> ParseInteger(std::string_view word);

}  // namespace mjforge::mesh_data
