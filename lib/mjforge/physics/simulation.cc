#include "mjforge/physics/simulation.h"

#include <algorithm>
#include <limits>
#include <span>

namespace mjforge::physics {
namespace {

constexpr int kMostContacts = 10'000;  // of 600 bytes

}  // namespace

mjData& Workspace::For(const mjModel& m) {
  // All numbers of mjModel that mjData's arrays depend on stand before nbuffer.
  const auto sizes = std::as_bytes(std::span(&m, 1)).first(offsetof(mjModel, nbuffer));
  if (data_ && std::ranges::equal(sizes, sizes_)) {
    mj_resetData(&m, data_.get());
    return *data_;
  }
  data_.reset();
  data_ = compiled::MakeData(m);
  sizes_.assign(sizes.begin(), sizes.end());
  return *data_;
}

bool MakeRoom(mjModel& m, const mjData& d) {
  const bool crowded =
      d.warning[mjWARN_CONTACTFULL].number > 0 || d.warning[mjWARN_CNSTRFULL].number > 0;
  if (!crowded || m.nconmax >= kMostContacts) return false;
  m.nconmax = std::min(4 * std::max(m.nconmax, 100), kMostContacts);
  m.njmax = std::max(m.njmax, 500) + 4 * m.nconmax;  // pyramids of condim 3
  // As for mjcf's sizes: linear in the contacts for a body or a few.
  const double numbers = m.nstack + 4000.0 * m.nconmax * std::max(1.0, m.nv / 24.0);
  m.nstack = static_cast<int>(std::min(numbers, std::numeric_limits<int>::max() / 16.0));
  return true;
}

bool HasBlownUp(const mjData& d) {
  return d.warning[mjWARN_BADQPOS].number > 0 || d.warning[mjWARN_BADQVEL].number > 0 ||
         d.warning[mjWARN_BADQACC].number > 0;
}

std::vector<std::string> WarningsOf(const mjData& d) {
  std::vector<std::string> warnings;
  for (int i = 0; i < mjNWARNING; ++i) {
    if (d.warning[i].number > 0) warnings.emplace_back(mju_warningText(i, d.warning[i].lastinfo));
  }
  return warnings;
}

}  // namespace mjforge::physics
