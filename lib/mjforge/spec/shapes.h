#pragma once

#include <span>
#include <string_view>

#include "mjforge/spec/keys.h"

namespace mjforge::spec {

/// A part's type, and which keys it takes.
struct ShapeInfo {
  std::string_view type;
  int sizes = 0;         // numbers in `size`; 0: it has no size
  int sizes_fromto = 0;  // the same beside `fromto`; 0: it has no fromto
  std::span<const Key> required = {};
  std::span<const Key> optional = {};  // besides size and fromto
  std::span<const Key> of_round = {};  // of these, what says how it is rounded

  bool Takes(Key key) const;
};
/// Null if there is none of that type.
const ShapeInfo* FindShape(std::string_view type);

/// Whether the key has a meaning for some shapes only.
bool IsOfAShape(Key key);

}  // namespace mjforge::spec
