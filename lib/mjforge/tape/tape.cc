#include "mjforge/tape/tape.h"

#include <algorithm>

namespace mjforge::tape {

bool Tape::Run() const {
  const auto take = [](const Step& step) { return step.take(step.state); };
  return std::ranges::all_of(early_, take) && std::ranges::all_of(steps_, take);
}

void Tape::SetOrigin(const double* copy, const double* original) {
  // What is a copy itself leads to its own origin.
  origins_[copy] = original == nullptr ? nullptr : OriginOf(original);
}

const double* Tape::OriginOf(const double* number) const {
  const auto found = origins_.find(number);
  return found == origins_.end() ? number : found->second;
}

void Links::Update() const {
  for (const Link& link : links_) std::copy_n(link.from, link.count, link.to);
}

}  // namespace mjforge::tape
