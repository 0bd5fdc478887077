// Systematic sample of a sequence whose length is not known in advance.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mjforge::report {

/// Keeps every 2^k-th item of a sequence, where k grows with the length of the sequence, so that
/// the kept items are spread evenly.
template <typename Item>
class SystematicSample {
 public:
  /// Keeps at least `least` items, or all of a shorter sequence, and at most twice as many.
  explicit SystematicSample(std::size_t least) : least_(least) {}

  void Add(const Item& item) {
    if (least_ > 0 && seen_ % stride_ == 0) {
      if (kept_.size() == 2 * least_) Thin();
      if (seen_ % stride_ == 0) kept_.push_back(item);
    }
    ++seen_;
  }

  std::uint64_t seen() const { return seen_; }

  /// Returns up to `count` of the kept items, in their order.
  std::vector<Item> Take(std::size_t count) const {
    const std::size_t taken = std::min(count, kept_.size());
    std::vector<Item> items;
    items.reserve(taken);
    for (std::size_t i = 0; i < taken; ++i) items.push_back(kept_[i * kept_.size() / taken]);
    return items;
  }

 private:
  void Thin() {
    // Start at 1, because a self-move would empty element 0.
    for (std::size_t i = 1; 2 * i < kept_.size(); ++i) kept_[i] = std::move(kept_[2 * i]);
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }

  std::size_t least_;
  std::uint64_t seen_ = 0;
  std::uint64_t stride_ = 1;
  std::vector<Item> kept_;
};

}  // namespace mjforge::report
