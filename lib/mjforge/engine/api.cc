// Functions of the compatibility layer for MuJoCo 2.2 to 4.0: MJCF keywords of actuator types, and
// sizes of the buffers of mjData.
#include "mjforge/engine/api.h"

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <utility>

namespace mjforge::engine {
namespace {

template <typename Type>
using Words = std::initializer_list<std::pair<Type, std::string_view>>;

// Returns the MJCF keyword of an enumerator; "user" if `words` does not contain the enumerator.
template <typename Type>
std::string_view Find(Type type, const Words<Type>& words) {
  const auto found = std::ranges::find(words, type, &std::pair<Type, std::string_view>::first);
  return found == words.end() ? "user" : found->second;
}

}  // namespace

std::string_view WordOf(mjtDyn dynamics) {
#if mjVERSION_HEADER >= 300
  if (dynamics == mjDYN_FILTEREXACT) return "filterexact";
#endif
  return Find(dynamics, {{mjDYN_NONE, "none"},
                         {mjDYN_INTEGRATOR, "integrator"},
                         {mjDYN_FILTER, "filter"},
                         {mjDYN_MUSCLE, "muscle"}});
}

std::string_view WordOf(mjtGain gain) {
  return Find(gain,
              {{mjGAIN_FIXED, "fixed"}, {mjGAIN_AFFINE, "affine"}, {mjGAIN_MUSCLE, "muscle"}});
}

std::string_view WordOf(mjtBias bias) {
  return Find(bias, {{mjBIAS_NONE, "none"}, {mjBIAS_AFFINE, "affine"}, {mjBIAS_MUSCLE, "muscle"}});
}

#if mjVERSION_HEADER >= 300
namespace {

// Memory, bytes, added to the computed size of the arena: enough for collision detection between
// two meshes. The operating system provides only the pages that MuJoCo touches.
constexpr double kLeast = 16e6;

}  // namespace

BufferSizes BufferSizesOf(const mjModel& m) {
  return {static_cast<int>(m.nconmax), static_cast<int>(m.njmax),
          static_cast<double>(m.narena) / sizeof(mjtNum)};
}

void SetBufferSizes(mjModel& m, const BufferSizes& sizes) {
  m.nconmax = sizes.contacts;
  m.njmax = sizes.rows;
  // A constraint row needs about 30 numbers, and two more for each degree of freedom.
  const double bytes =
      sizeof(mjtNum) * (sizes.numbers + (30.0 + 2.0 * static_cast<double>(m.nv)) * sizes.rows) +
      1.0 * sizeof(mjContact) * sizes.contacts;
  m.narena = static_cast<decltype(m.narena)>(kLeast + bytes);
}
#else
BufferSizes BufferSizesOf(const mjModel& m) {
  return {m.nconmax, m.njmax, static_cast<double>(m.nstack)};
}

void SetBufferSizes(mjModel& m, const BufferSizes& sizes) {
  m.nconmax = sizes.contacts;
  m.njmax = sizes.rows;
  // MuJoCo computes the size of the stack in bytes (8 per number) as an int. This limit is half of
  // the largest int.
  constexpr double kMost = std::numeric_limits<int>::max() / 16.0;
  m.nstack = static_cast<int>(std::min(sizes.numbers, kMost));
}
#endif

}  // namespace mjforge::engine
