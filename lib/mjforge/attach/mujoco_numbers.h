#ifndef MJFORGE_ATTACH_MUJOCO_NUMBERS_H_
#define MJFORGE_ATTACH_MUJOCO_NUMBERS_H_

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

#endif  // MJFORGE_ATTACH_MUJOCO_NUMBERS_H_
