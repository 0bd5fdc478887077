// Parsing and formatting of the numbers in values of XML attributes.
#include "mjforge/xml/attribute_numbers.h"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/expr/expr.h"

namespace mjforge::xml {

std::vector<double> NumbersOf(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : expr::WordsOf(text)) {
    const std::optional<double> number = expr::ParseNumber(word);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::string TextOf(const std::vector<double>& numbers) {
  return fmt::format("{}", fmt::join(numbers, " "));
}

}  // namespace mjforge::xml
