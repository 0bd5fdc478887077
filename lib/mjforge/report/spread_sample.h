#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mjforge::report {

/// Some of many items, evenly spread over them, though their number is not known in advance: every
/// 2^k-th is kept, and k grows with their number.
template <typename Item>
class SpreadSample {
 public:
  /// `least`: how many Take() can give if there are as many; at most twice as many are kept.
  explicit SpreadSample(std::size_t least) : least_(least) {}

  void Add(const Item& item) {
    if (least_ > 0 && seen_ % stride_ == 0) {
      if (kept_.size() == 2 * least_) Thin();
      if (seen_ % stride_ == 0) kept_.push_back(item);
    }
    ++seen_;
  }

  std::uint64_t seen() const { return seen_; }

  /// Up to `count` of them, in the order they came.
  std::vector<Item> Take(std::size_t count) const {
    const std::size_t taken = std::min(count, kept_.size());
    std::vector<Item> items;
    items.reserve(taken);
    for (std::size_t i = 0; i < taken; ++i) items.push_back(kept_[i * kept_.size() / taken]);
    return items;
  }

 private:
  void Thin() {
    // The first stays: moved to itself it would lose what it has.
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
