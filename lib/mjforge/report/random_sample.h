// Random sample of indexed items whose number is not known in advance.

#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::report {

/// Sample of the items with the lowest ranks, where the rank of an item is a hash of its index. The
/// sample does not depend on the order of the items, or on their division among samples that
/// Append() joins. Regularities of the items (grids, Sobol points) do not bias the sample.
template <typename Item>
class RandomSample {
 public:
  /// Keeps at most `most` items.
  explicit RandomSample(std::size_t most) : most_(most) {}

  void Add(std::uint64_t index, const Item& item) {
    ++seen_;
    Keep({HashOf(index), index}, item);
  }
  /// Adds the items that another sample with the same `most` has seen.
  void Append(const RandomSample& other) {
    seen_ += other.seen_;
    for (const Entry& entry : other.kept_) Keep(entry.rank, entry.item);
  }

  std::uint64_t seen() const { return seen_; }

  /// Returns the `count` kept items with the lowest ranks, or all if there are fewer, in the order
  /// of their indices.
  std::vector<Item> Take(std::size_t count) const {
    auto taken = diag::Mapped<const Entry*>(kept_, [](const Entry& entry) { return &entry; });
    std::ranges::sort(taken, {}, &Entry::rank);
    taken.resize(std::min(count, taken.size()));
    std::ranges::stable_sort(taken, {}, [](const Entry* entry) { return entry->rank.index; });
    return diag::Mapped<Item>(taken, &Entry::item);
  }

 private:
  struct Rank {
    std::uint64_t hash = 0;
    std::uint64_t index = 0;
    auto operator<=>(const Rank&) const = default;
  };
  struct Entry {
    Rank rank;
    Item item;
  };

  // Output function of SplitMix64 (Steele, Lea and Flood 2014).
  static std::uint64_t HashOf(std::uint64_t index) {
    std::uint64_t hash = index + 0x9e3779b97f4a7c15;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111eb;
    return hash ^ hash >> 31;
  }

  void Keep(const Rank& rank, const Item& item) {
    if (kept_.size() == most_) {
      if (most_ == 0 || kept_.front().rank <= rank) return;
      std::ranges::pop_heap(kept_, {}, &Entry::rank);
      kept_.pop_back();
    }
    kept_.push_back({rank, item});
    std::ranges::push_heap(kept_, {}, &Entry::rank);
  }

  std::size_t most_;
  std::uint64_t seen_ = 0;
  std::vector<Entry> kept_;  // a heap with the highest rank on top
};

}  // namespace mjforge::report
