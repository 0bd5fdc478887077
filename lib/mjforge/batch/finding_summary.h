// Findings of many variants, grouped by code and place.

#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::batch {

/// Findings of many variants, grouped by code and place: the first finding of each group, and the
/// number of variants that have it. Messages within a group contain different values, but have the
/// same cause in the spec.
class FindingSummary {
 public:
  struct Group {
    diag::Finding finding;  // finding of the group's first variant
    std::uint64_t variants = 0;
    std::uint64_t last_index = 0;  // index of the last variant that was counted
  };

  explicit FindingSummary(std::size_t limit) : limit_(limit) {}

  /// Adds the findings of one variant; with `as_warnings`, errors become warnings.
  void Add(const diag::Findings& findings, bool as_warnings);
  /// Merges a group of another summary, whose variants must have higher indices.
  void Add(Group group);
  void AddNotShown(std::uint64_t count) { not_shown_ += count; }

  std::span<const Group> groups() const { return groups_; }
  /// Returns the first finding of each group, in file order.
  diag::Findings Findings() const;
  std::uint64_t not_shown() const { return not_shown_; }

 private:
  // Code, place, place of the first note, and message of a finding. The place of the note is
  // included because all findings of an attached file have one place in the spec. The message is
  // empty for findings that have a place.
  using Key = std::tuple<diag::Code, diag::SourceMark, diag::SourceMark, std::string>;

  std::size_t limit_;
  std::map<Key, std::size_t> numbers_;  // indices in groups_
  std::vector<Group> groups_;
  std::uint64_t not_shown_ = 0;
};

}  // namespace mjforge::batch
