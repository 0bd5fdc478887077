// Keywords of MJCF and sizes of buffers, for releases 2.2 to 4.0 of MuJoCo.
#include "mjforge/engine/api.h"

#include <algorithm>
#include <limits>

namespace mjforge::engine {

std::string_view WordOf(mjtDyn dynamics) {
  switch (dynamics) {
    case mjDYN_NONE:
      return "none";
    case mjDYN_INTEGRATOR:
      return "integrator";
    case mjDYN_FILTER:
      return "filter";
    case mjDYN_MUSCLE:
      return "muscle";
#if mjVERSION_HEADER >= 300
    case mjDYN_FILTEREXACT:
      return "filterexact";
#endif
    default:
      return "user";
  }
}

std::string_view WordOf(mjtGain gain) {
  switch (gain) {
    case mjGAIN_FIXED:
      return "fixed";
    case mjGAIN_AFFINE:
      return "affine";
    case mjGAIN_MUSCLE:
      return "muscle";
    default:
      return "user";
  }
}

std::string_view WordOf(mjtBias bias) {
  switch (bias) {
    case mjBIAS_NONE:
      return "none";
    case mjBIAS_AFFINE:
      return "affine";
    case mjBIAS_MUSCLE:
      return "muscle";
    default:
      return "user";
  }
}

#if mjVERSION_HEADER >= 300
namespace {

// Smallest arena, bytes: enough for collision detection between two meshes. Untouched pages cost
// nothing.
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
  // MuJoCo computes the size of the stack in bytes (8 per number) as an int.
  constexpr double kMost = std::numeric_limits<int>::max() / 16.0;
  m.nstack = static_cast<int>(std::min(sizes.numbers, kMost));
}
#endif

}  // namespace mjforge::engine
