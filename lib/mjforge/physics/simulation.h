#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

/// MuJoCo's mjData, kept from one model to the next where it fits: most members
/// of a family have the same sizes, and making it costs as much as 50 steps.
class Workspace {
 public:
  /// Data for the model at its initial state, valid until the next call. Throws std::exception if
  /// there is not enough memory.
  mjData& For(const mjModel& m);

 private:
  compiled::Data data_;
  std::vector<std::byte> sizes_;  // of the model it was made for
};

/// Makes more room for contacts and constraint rows if one of them ran out of it in the last steps.
/// True if it did: the data must then be made anew. False, too, if that would be too much.
bool MakeRoom(mjModel& m, const mjData& d);

struct Fastest {
  double speed = 0;  // m/s
  int body = 0;
};
/// The fastest point, no point of a geom being farther from its body's centre of mass than the
/// geom's centre and bounding radius say.
Fastest FastestPoint(const mjModel& m, const mjData& d);

/// How deep the deepest contact is, m.
double DeepestContact(const mjData& d);

/// Whether MuJoCo found numbers that are NaN or too large and reset the data.
bool HasBlownUp(const mjData& d);
/// MuJoCo's words for what went wrong since the data was reset.
std::vector<std::string> WarningsOf(const mjData& d);

}  // namespace mjforge::physics
