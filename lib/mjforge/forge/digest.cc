#include "mjforge/forge/digest.h"

#include <fmt/format.h>

namespace mjforge::forge {

void Digest::Add(const diag::Findings& findings, bool as_warnings) {
  for (const diag::Finding& finding : findings) {
    const diag::SourceMark other =
        finding.notes.empty() ? diag::SourceMark() : finding.notes.front().mark;
    const Key key{finding.code, finding.mark, other,
                  finding.mark ? std::string() : finding.message};
    const std::uint64_t index = finding.index.value_or(0);
    const auto known = positions_.find(key);
    if (known != positions_.end()) {
      Entry& entry = entries_[known->second];
      if (entry.last_index != index) ++entry.variants;
      entry.last_index = index;
      continue;
    }
    if (entries_.size() == limit_) {
      ++not_shown_;
      continue;
    }
    positions_.emplace(key, entries_.size());
    entries_.push_back({finding, 1, index});
    if (as_warnings) entries_.back().finding.severity = diag::Severity::kWarning;
  }
}

diag::Findings Digest::Result() const {
  diag::Findings result;
  for (const Entry& entry : entries_) {
    diag::Finding& finding =
        result.Add(entry.finding.code, entry.finding.mark, entry.finding.message);
    finding = entry.finding;
    if (entry.variants > 1) {
      finding.notes.push_back(
          {{}, fmt::format("{} variants have this finding; this is the first", entry.variants)});
    }
  }
  result.Sort();
  return result;
}

}  // namespace mjforge::forge
