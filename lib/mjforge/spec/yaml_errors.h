// Clear messages and hints for the syntax errors that yaml-cpp reports.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mjforge::spec {

struct SyntaxError {
  std::string message;
  std::string hint;  // may be empty
};

/// Explains an error that yaml-cpp found at a column (counted from 1) of a line. Recognizes
/// expressions of specs that YAML misinterprets: `${...}` in braces, `c ? a : b`, `widths[i]`.
SyntaxError ExplainSyntax(const std::string& error, std::string_view line, std::size_t column);

}  // namespace mjforge::spec
