#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::batch {

/// The findings of many variants in little room: the first of each kind and place, and how many
/// variants had it. Values differ from variant to variant, and so do messages, but there is one
/// mistake to mend.
class FindingSummary {
 public:
  struct Group {
    diag::Finding finding;  // of the first variant that has it
    std::uint64_t variants = 0;
    std::uint64_t last_index = 0;
  };

  explicit FindingSummary(std::size_t limit) : limit_(limit) {}

  /// The findings of one variant.
  void Add(const diag::Findings& findings, bool as_warnings);
  /// Another digest's group about later variants.
  void Add(Group group);
  void AddNotShown(std::uint64_t count) { not_shown_ += count; }

  std::span<const Group> groups() const { return groups_; }
  /// In file order.
  diag::Findings Findings() const;
  std::uint64_t not_shown() const { return not_shown_; }

 private:
  // The place, the first note's place (all findings of an attached file have the same place in the
  // spec), and, without a place, the message.
  using Key = std::tuple<diag::Code, diag::SourceMark, diag::SourceMark, std::string>;

  std::size_t limit_;
  std::map<Key, std::size_t> numbers_;
  std::vector<Group> groups_;
  std::uint64_t not_shown_ = 0;
};

}  // namespace mjforge::batch
