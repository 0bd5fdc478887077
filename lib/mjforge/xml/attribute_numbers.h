// Numbers in the values of XML attributes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjforge::xml {

/// Returns the numbers of a list that is separated by blanks; an empty list if a word is not a
/// number.
std::vector<double> NumbersOf(std::string_view text);
/// Returns the numbers as text, separated by blanks. Each number is the shortest text that is
/// parsed as exactly this number.
std::string TextOf(const std::vector<double>& numbers);

}  // namespace mjforge::xml
