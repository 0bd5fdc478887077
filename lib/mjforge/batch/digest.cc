#include "mjforge/batch/digest.h"

#include <fmt/format.h>

#include <utility>

namespace mjforge::batch {

void Digest::Add(const diag::Findings& findings, bool as_warnings) {
  for (const diag::Finding& finding : findings) {
    Entry entry{finding, 1, finding.index.value_or(0)};
    if (as_warnings) entry.finding.severity = diag::Severity::kWarning;
    Add(std::move(entry));
  }
}

void Digest::Add(Entry entry) {
  const diag::Finding& finding = entry.finding;
  const diag::SourceMark other =
      finding.notes.empty() ? diag::SourceMark() : finding.notes.front().mark;
  // What a worker died of is at the spec's first line, and another cause with each variant.
  const bool by_words = !finding.mark || finding.code == diag::Code::kBatchWorkerDied ||
                        finding.code == diag::Code::kBatchTooSlow;
  Key key{finding.code, finding.mark, other, by_words ? finding.message : std::string()};
  if (const auto known = positions_.find(key); known != positions_.end()) {
    Entry& present = entries_[known->second];
    // A variant may have it at one place more than once.
    if (present.last_index != entry.last_index) present.variants += entry.variants;
    present.last_index = entry.last_index;
  } else if (entries_.size() == limit_) {
    not_shown_ += entry.variants;
  } else {
    positions_.emplace(std::move(key), entries_.size());
    entries_.push_back(std::move(entry));
  }
}

diag::Findings Digest::Result() const {
  diag::Findings result;
  for (const Entry& entry : entries_) {
    diag::Finding& finding = result.Add(entry.finding);
    if (entry.variants > 1) {
      finding.notes.push_back(
          {{}, fmt::format("{} variants have this finding; this is the first", entry.variants)});
    }
  }
  result.Sort();
  return result;
}

}  // namespace mjforge::batch
