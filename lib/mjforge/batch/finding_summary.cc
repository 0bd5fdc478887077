// Grouping of the findings of many variants by code and place.

#include "mjforge/batch/finding_summary.h"

#include <fmt/format.h>

#include <utility>

namespace mjforge::batch {

void FindingSummary::Add(const diag::Findings& findings, bool as_warnings) {
  for (const diag::Finding& finding : findings) {
    Group group{finding, 1, finding.index.value_or(0)};
    if (as_warnings) group.finding.severity = diag::Severity::kWarning;
    Add(std::move(group));
  }
}

void FindingSummary::Add(Group group) {
  const diag::Finding& finding = group.finding;
  const diag::SourceMark other =
      finding.notes.empty() ? diag::SourceMark() : finding.notes.front().mark;
  Key key{finding.code, finding.mark, other, finding.mark ? std::string() : finding.message};
  if (const auto known = numbers_.find(key); known != numbers_.end()) {
    Group& present = groups_[known->second];
    // Counts a variant once, even if it has several findings that belong to the group.
    if (present.last_index != group.last_index) present.variants += group.variants;
    present.last_index = group.last_index;
  } else if (groups_.size() == limit_) {
    not_shown_ += group.variants;
  } else {
    numbers_.emplace(std::move(key), groups_.size());
    groups_.push_back(std::move(group));
  }
}

diag::Findings FindingSummary::Findings() const {
  diag::Findings result;
  for (const Group& group : groups_) {
    diag::Finding& finding = result.Add(group.finding);
    if (group.variants > 1) {
      finding.notes.push_back(
          {{}, fmt::format("{} variants have this finding; this is the first", group.variants)});
    }
  }
  result.Sort();
  return result;
}

}  // namespace mjforge::batch
