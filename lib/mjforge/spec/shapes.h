// The types of parts and the keys that each type takes.

#pragma once

#include <span>
#include <string_view>

#include "mjforge/spec/keys.h"

namespace mjforge::spec {

/// A type of part ("box"), and the keys that parts of the type take.
struct ShapeInfo {
  std::string_view type;
  int sizes = 0;         // count of numbers in `size`; 0: the type has no `size`
  int sizes_fromto = 0;  // count of numbers in `size` beside `fromto`; 0: the type has no `fromto`
  std::span<const Key> required = {};
  std::span<const Key> optional = {};           // optional keys, without `size` and `fromto`
  std::span<const Key> optional_if_round = {};  // optional keys that require the key `round`

  bool Takes(Key key) const;
};
/// Returns the part type with this name; null if there is none.
const ShapeInfo* FindShape(std::string_view type);

/// Returns true if at least one type of part takes the key.
bool AnyShapeTakes(Key key);

}  // namespace mjforge::spec
