#ifndef MJFORGE_MANIFEST_READER_H_
#define MJFORGE_MANIFEST_READER_H_

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"

namespace mjforge::manifest {

struct Record;

/// The records of a manifest, one after the other: it may have a hundred million,
/// and takes no more memory for them.
class RecordReader {
 public:
  /// Nothing, and a finding, if the file cannot be read. Sources and findings must
  /// outlive the reader: a line that is no record is a finding at its place.
  static std::optional<RecordReader> Open(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings);

  enum class Outcome { kRecord, kBadLine, kEnd };
  /// Replaces `record` by that of the next line. After a bad line, of which only a
  /// finding is left, it may go on with the one that follows; of more than
  /// kMaxBadLines the others are only counted.
  Outcome Next(Record& record);
  static constexpr std::uint64_t kMaxBadLines = 50;
  std::uint64_t bad_lines() const { return bad_lines_; }

  /// The last line: its number, from 1 up, and its text without the end.
  std::uint32_t number() const { return number_; }
  const std::string& text() const { return text_; }
  /// Whether that line has no end, as one that was being written.
  bool torn() const { return lines_.eof(); }
  /// The place of that line, for further findings about it.
  diag::SourceMark Mark() const;

 private:
  RecordReader(std::ifstream lines, std::string name, diag::Sources& sources,
               diag::Findings& findings);

  std::ifstream lines_;
  std::string name_;
  diag::Sources* sources_;
  diag::Findings* findings_;
  std::string text_;
  std::uint32_t number_ = 0;
  std::uint64_t bad_lines_ = 0;
};

}  // namespace mjforge::manifest

#endif  // MJFORGE_MANIFEST_READER_H_
