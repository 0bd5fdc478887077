#pragma once

#include <span>
#include <string_view>

namespace mjforge::diag {

/// Every kind of finding, grouped by what was being done, which the first part of its name also
/// says. docs/errors.md has a chapter for each and tests/golden a case; tests compare them.
enum class Code {
#define MJFORGE_CODE(code, name, meaning) code,
#include "mjforge/diag/codes.inc"
};

struct CodeInfo {
  Code code;
  std::string_view name;     // "spec/unknown-key"
  std::string_view meaning;  // one line, for the catalogue
};

/// All codes, in the order of the enumeration.
std::span<const CodeInfo> AllCodes();

std::string_view CodeName(Code code);

/// True for codes that mean "input or output failed" (exit status 3) rather
/// than "the input is wrong" (exit status 1).
bool IsInputOutput(Code code);

}  // namespace mjforge::diag
