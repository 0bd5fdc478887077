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

// What one pair of meshes may need while their contacts are sought. Pages that nobody touches cost
// nothing.
constexpr double kLeast = 16e6;

}  // namespace

Room RoomOf(const mjModel& m) {
  return {static_cast<int>(m.nconmax), static_cast<int>(m.njmax),
          static_cast<double>(m.narena) / sizeof(mjtNum)};
}

void SetRoom(mjModel& m, const Room& room) {
  m.nconmax = room.contacts;
  m.njmax = room.rows;
  // A row has a few numbers of its own and one for each degree of freedom, twice.
  const double bytes =
      sizeof(mjtNum) * (room.numbers + (30.0 + 2.0 * static_cast<double>(m.nv)) * room.rows) +
      1.0 * sizeof(mjContact) * room.contacts;
  m.narena = static_cast<decltype(m.narena)>(kLeast + bytes);
}
#else
Room RoomOf(const mjModel& m) { return {m.nconmax, m.njmax, static_cast<double>(m.nstack)}; }

void SetRoom(mjModel& m, const Room& room) {
  m.nconmax = room.contacts;
  m.njmax = room.rows;
  constexpr double kMost = std::numeric_limits<int>::max() / 16.0;  // it counts bytes in an int
  m.nstack = static_cast<int>(std::min(room.numbers, kMost));
}
#endif

}  // namespace mjforge::engine
