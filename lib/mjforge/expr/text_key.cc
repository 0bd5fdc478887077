// TextKey(): the number that represents a text in expressions.
#include <xxhash.h>

#include <cstdint>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

double TextKey(std::string_view text) {
  // A number of 52 bits is exact as a double.
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 52) - 1;
  return static_cast<double>(XXH64(text.data(), text.size(), 0) & kMask);
}

}  // namespace mjforge::expr
