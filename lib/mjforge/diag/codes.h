// Codes of findings: names, one-line meanings, and the exit status that a code causes.

#pragma once

#include <span>
#include <string_view>

namespace mjforge::diag {

/// All kinds of findings, grouped by the stage that reports them; the stage is the first part of
/// the code's name. Tests check that docs/errors.md has a chapter with an example for each code,
/// and run the examples.
enum class Code {
#define MJFORGE_CODE(code, name, meaning) code,
#include "mjforge/diag/codes.inc"
};

struct CodeInfo {
  Code code;
  std::string_view name;     // "spec/unknown-key"
  std::string_view meaning;  // a single line
};

/// Returns all codes, in the order of the enumeration.
std::span<const CodeInfo> AllCodes();

std::string_view CodeName(Code code);

/// Returns true for codes of failed input or output (exit status 3). The other codes mean that the
/// input is wrong (exit status 1).
bool IsInputOutput(Code code);

}  // namespace mjforge::diag
