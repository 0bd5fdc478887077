// Source texts with their line starts, and the list of findings.

#include "mjforge/diag/diag.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace mjforge::diag {

std::uint32_t Sources::Add(std::string name, std::string text, std::uint32_t first_line) {
  File& file = files_.emplace_back(File{std::move(name), std::move(text), first_line});
  std::size_t start = 0;
  do {
    file.line_starts.push_back(start);
    start = file.text.find('\n', start) + 1;
  } while (start != 0);
  return size();
}

std::string_view Sources::Line(SourceMark mark) const {
  if (mark.file == 0 || mark.file > files_.size()) return {};
  const File& file = files_[mark.file - 1];
  if (mark.line < file.first_line || mark.line - file.first_line >= file.line_starts.size())
    return {};
  std::string_view rest = file.text;
  rest.remove_prefix(file.line_starts[mark.line - file.first_line]);
  rest = rest.substr(0, rest.find('\n'));
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  return rest;
}

Finding& Findings::Add(Code code, SourceMark mark, std::string message, std::string hint) {
  return Add({Severity::kError, code, mark, std::move(message), std::move(hint)});
}

Finding& Findings::Warn(Code code, SourceMark mark, std::string message, std::string hint) {
  return Add({Severity::kWarning, code, mark, std::move(message), std::move(hint)});
}

Finding& Findings::AddCannotRead(std::string_view file, std::string_view why_not) {
  return Add(Code::kYamlCannotRead, {}, fmt::format("cannot read '{}': {}", file, why_not));
}

void Findings::Append(Findings other) {
  list_.insert(list_.end(), std::make_move_iterator(other.list_.begin()),
               std::make_move_iterator(other.list_.end()));
}

const Finding* Findings::FirstError(std::size_t first) const {
  return Find(std::span(list_).subspan(first), Severity::kError, &Finding::severity);
}

void Findings::SetVariant(std::uint64_t seed, std::uint64_t index) {
  for (Finding& finding : list_) {
    if (finding.seed || finding.index) continue;
    finding.seed = seed;
    finding.index = index;
  }
}

void Findings::Sort() {
  std::stable_sort(list_.begin(), list_.end(),
                   [](const Finding& a, const Finding& b) { return a.mark < b.mark; });
}

void Findings::Unique() {
  std::set<std::tuple<Code, SourceMark, std::string>> seen;
  std::erase_if(list_, [&seen](const Finding& finding) {
    return !seen.emplace(finding.code, finding.mark, finding.message).second;
  });
}

void Findings::Fold(Code code, std::size_t most) {
  std::map<std::pair<std::uint32_t, std::string>, std::size_t> counts;
  const auto key = [](const Finding& finding) {
    return std::pair(finding.mark.file, finding.message);
  };
  for (const Finding& finding : list_) {
    if (finding.code == code) ++counts[key(finding)];
  }
  std::erase_if(counts, [&](const auto& count) { return count.second <= most; });
  std::erase_if(list_, [&](Finding& finding) {
    const auto found = finding.code == code ? counts.find(key(finding)) : counts.end();
    if (found == counts.end()) return false;
    if (found->second == 0) return true;
    finding.message += fmt::format(", and at {} other places", std::exchange(found->second, 0) - 1);
    return false;
  });
}

std::nullopt_t Refuse(std::string& why_not, std::string reason) {
  why_not = std::move(reason);
  return std::nullopt;
}

std::string_view CutAt(char separator, std::string_view& text) {
  const std::string_view start = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(start.size() + 1, text.size()));
  return start;
}

std::string Counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string Counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace mjforge::diag
