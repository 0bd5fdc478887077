#pragma once

// Numbers out of mjModel's arrays.

#include <cstddef>
#include <span>

namespace mjforge::attach {

/// The id-th group of `count` numbers.
template <typename T>
std::span<const T> Row(const T* array, int id, int count) {
  return {array + static_cast<std::ptrdiff_t>(id) * count, static_cast<std::size_t>(count)};
}

}  // namespace mjforge::attach
