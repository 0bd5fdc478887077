// Conversion between the values of XML attributes and lists of numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjforge::xml {

/// Returns the numbers in a text that are separated by blanks; an empty list if any word is not a
/// number.
std::vector<double> NumbersOf(std::string_view text);
/// Returns the numbers as text, separated by blanks. Each number is the shortest text that is
/// parsed as exactly this number.
std::string TextOf(const std::vector<double>& numbers);

}  // namespace mjforge::xml
