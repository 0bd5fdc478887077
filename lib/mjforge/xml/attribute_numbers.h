// Numbers in the values of XML attributes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjforge::xml {

/// Returns the numbers of a list separated by blanks; an empty vector if a word is not a number.
std::vector<double> NumbersOf(std::string_view text);
/// Returns the numbers separated by blanks, each in the shortest form that is read back exactly.
std::string TextOf(const std::vector<double>& numbers);

}  // namespace mjforge::xml
