// Table of the codes of findings, generated from codes.inc, and functions that query the table.

#include "mjforge/diag/codes.h"

#include <cstddef>

namespace mjforge::diag {
namespace {

constexpr CodeInfo kCodes[] = {
#define MJFORGE_CODE(code, name, meaning) {Code::code, name, meaning},
#include "mjforge/diag/codes.inc"
};

}  // namespace

std::span<const CodeInfo> AllCodes() { return kCodes; }

std::string_view CodeName(Code code) { return kCodes[static_cast<std::size_t>(code)].name; }

bool IsInputOutput(Code code) {
  return code == Code::kYamlCannotRead || code == Code::kOutputExists ||
         code == Code::kOutputCannotWrite;
}

}  // namespace mjforge::diag
