// Codes of findings (errors and warnings): names, one-line meanings, and the exit status of a code.

#pragma once

#include <span>
#include <string_view>

namespace mjforge::diag {

/// All kinds of findings, grouped by the stage of the program that reports them. The name of a code
/// begins with the stage ("spec/unknown-key"). Tests check that docs/errors.md has a chapter with
/// an example for each code, and run the examples.
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

/// Returns true for codes of files that cannot be read or written (exit status 3). An error with
/// another code causes exit status 1.
bool IsInputOutput(Code code);

}  // namespace mjforge::diag
