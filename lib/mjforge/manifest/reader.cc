#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

RecordReader::RecordReader(std::ifstream lines, std::string name, diag::Sources& sources,
                           diag::Findings& findings)
    : lines_(std::move(lines)), name_(std::move(name)), sources_(&sources), findings_(&findings) {}

std::optional<RecordReader> RecordReader::Open(const std::filesystem::path& file,
                                               diag::Sources& sources, diag::Findings& findings) {
  std::error_code ignored;
  // A folder can be opened, and has no line.
  const bool is_folder = std::filesystem::is_directory(file, ignored);
  errno = 0;
  std::ifstream lines(file, std::ios::binary);
  if (!lines || is_folder) {
    const int error = is_folder ? EISDIR : errno;
    findings.Add(
        diag::Code::kYamlCannotRead, {},
        fmt::format("cannot read '{}': {}", file.string(), std::generic_category().message(error)));
    return std::nullopt;
  }
  return RecordReader(std::move(lines), file.string(), sources, findings);
}

RecordReader::Outcome RecordReader::Next(Record& record) {
  if (!std::getline(lines_, text_)) return Outcome::kEnd;
  ++number_;
  std::string why_not;
  std::optional<Record> read = ReadRecord(text_, why_not);
  if (read) {
    record = *std::move(read);
    return Outcome::kRecord;
  }
  if (++bad_lines_ <= kMaxBadLines) {
    findings_->Add(diag::Code::kOutputBadManifest, Mark(),
                   fmt::format("this line is not a record: {}", why_not));
  }
  return Outcome::kBadLine;
}

diag::SourceMark RecordReader::Mark() const {
  return {sources_->Add(name_, text_, number_), number_, 1};
}

}  // namespace mjforge::manifest
