// Reading a manifest record by record, in constant memory.

#include <fmt/format.h>

#include <utility>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

RecordReader::RecordReader(bytes::LineReader lines, std::string name, diag::Sources& sources,
                           diag::Findings& findings)
    : lines_(std::move(lines)), name_(std::move(name)), sources_(&sources), findings_(&findings) {}

std::optional<std::vector<std::uint64_t>> CutsOf(const std::filesystem::path& file,
                                                 diag::Findings& findings) {
  std::string why_not;
  auto cuts = bytes::CutsOf(file, why_not);
  if (!cuts) findings.AddCannotRead(file.string(), why_not);
  return cuts;
}

std::optional<RecordReader> RecordReader::Open(const std::filesystem::path& file,
                                               diag::Sources& sources, diag::Findings& findings,
                                               const bytes::FileSection& section) {
  std::string why_not;
  std::optional<bytes::LineReader> lines = bytes::LineReader::Open(file, why_not, section);
  if (!lines) {
    findings.AddCannotRead(file.string(), why_not);
    return std::nullopt;
  }
  return RecordReader(*std::move(lines), file.string(), sources, findings);
}

RecordReader::Outcome RecordReader::Next(Record& record) {
  std::string why_not;
  if (!lines_.Next(text_, why_not)) {
    if (why_not.empty()) return Outcome::kEnd;
    ++number_;
    text_.clear();
    findings_->Add(diag::Code::kYamlCannotRead, Mark(),
                   fmt::format("cannot read this line: {}", why_not));
    return Outcome::kUnreadable;
  }
  ++number_;
  std::optional<Record> read = ReadRecord(text_, why_not);
  if (read) {
    record = *std::move(read);
    return Outcome::kRecord;
  }
  if (++bad_lines_ <= kMaxBadLines) {
    findings_->Add(diag::Code::kOutputBadManifest, Mark(),
                   fmt::format("this line is not a record: {}", why_not));
  }
  if (bad_lines_ <= kMaxSkippedLines) return Outcome::kBadLine;
  findings_->Add(
      diag::Code::kYamlCannotRead, Mark(),
      fmt::format("the rest is not read: more than {} lines are not records", kMaxSkippedLines));
  return Outcome::kUnreadable;
}

diag::SourceMark RecordReader::Mark() const {
  return {sources_->Add(name_, text_, number_), number_, 1};
}

}  // namespace mjforge::manifest
