#pragma once

// What is known of each variant of a batch, one line of JSON per variant.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/manifest/seal.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/sample/sample.h"

namespace mjforge::manifest {

/// What became of a variant: "ok", "failed", "skipped". Failed and skipped ones have errors among
/// their findings and no file.
enum class Status { kOk, kFailed, kSkipped };
/// What is checked of each variant: nothing, whether MuJoCo loads it as meant, or whether it also
/// behaves.
enum class Validation { kNone, kLoad, kPhysics };
enum class OnInvalid {
  kFail,      // the variant is reported, the others are made
  kSkip,      // the same, as a warning
  kResample,  // drawn again, up to forge::kMaxResamples times; then as kFail
};

// Their words, in their order.
inline constexpr std::string_view kStatuses[] = {"ok", "failed", "skipped"};
inline constexpr std::string_view kValidations[] = {"none", "load", "physics"};
inline constexpr std::string_view kOnInvalid[] = {"fail", "skip", "resample"};
constexpr std::span<const std::string_view> WordsOf(Status) { return kStatuses; }
constexpr std::span<const std::string_view> WordsOf(Validation) { return kValidations; }
constexpr std::span<const std::string_view> WordsOf(OnInvalid) { return kOnInvalid; }

inline constexpr Status kByName[] = {Status::kFailed, Status::kOk, Status::kSkipped};

template <typename Enum>
constexpr std::string_view NameOf(Enum value) {
  return WordsOf(value)[static_cast<std::size_t>(value)];
}
/// Nothing if it is not one of the words.
template <typename Enum>
constexpr std::optional<Enum> Find(std::string_view word) {
  for (std::size_t i = 0; i < WordsOf(Enum()).size(); ++i) {
    if (WordsOf(Enum())[i] == word) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

/// How many variants have each status.
struct StatusCounts {
  std::uint64_t ok = 0;
  std::uint64_t failed = 0;
  std::uint64_t skipped = 0;

  std::uint64_t Of(Status status) const {
    return status == Status::kOk ? ok : status == Status::kFailed ? failed : skipped;
  }
  void Add(Status status) {
    ++(status == Status::kOk ? ok : status == Status::kFailed ? failed : skipped);
  }
  std::uint64_t done() const { return ok + failed + skipped; }
};

/// One line of manifest.jsonl: what its variant's file says of how it was made (the name always),
/// and what came of it.
struct Record : mjcf::Provenance {
  std::string file;       // relative to the manifest, or in the archive; empty: none was written
  std::string archive;    // relative to the manifest; empty: the file is not in an archive
  std::string spec_file;  // from the manifest's folder; empty: found by name, or not known
  std::uint64_t attempt = 0;
  std::vector<std::pair<std::string, sample::ParameterValue>> params;
  model::MassProperties mass_properties;
  model::Bounds bounds;
  // As MuJoCo counts them in the file. nbody counts the world; 0: no object was
  // made, and masses, bounds and counts mean nothing.
  int nbody = 0;
  int njnt = 0;
  int ngeom = 0;
  Validation validate = Validation::kLoad;
  std::optional<physics::Result> physics;  // where it was asked for and could be measured
  OnInvalid on_invalid = OnInvalid::kFail;
  Status status = Status::kOk;
  std::vector<std::string> findings;  // JSON objects, as diag::RenderJson makes them
  std::string sha256;                 // of the file's bytes; empty: none was written
  // What the file refers to: name in it, SHA-256 of the bytes. Empty if none was written.
  std::vector<std::pair<std::string, std::string>> assets;
};

/// Appends one JSON object and a line end.
void AppendRecord(std::string& out, const Record& record);

/// Writes the same lines faster where records follow each other that differ in numbers only, as
/// those of a batch do.
class RecordWriter {
 public:
  RecordWriter();
  ~RecordWriter();

  void Append(std::string& out, const Record& record);

 private:
  class Form;
  /// For the record; null if it is to be written field by field.
  Form* FormOf(const Record& record);

  std::vector<std::unique_ptr<Form>> forms_;  // the one used last first
  std::vector<double> numbers_;               // of the record at hand
  std::uint64_t made_ = 0;                    // forms
  std::uint64_t hits_ = 0;                    // records from them
};

/// Appends `line`, a record as AppendRecord writes it, with the two members that it lacks:
/// `archive` and, unless that is empty, `spec_file`.
void AppendWithPlaces(std::string& out, std::string_view line, const std::string& archive,
                      const std::string& spec_file);

/// What was measured, as a record's `physics` has it.
std::string PhysicsJson(const physics::Result& result);

/// Nothing, and why, if the line is not a record.
std::optional<Record> ReadRecord(std::string_view line, std::string& why_not);

/// Reads the records of a manifest one after the other, in constant memory: there may be a hundred
/// million.
class RecordReader {
 public:
  /// Nothing, and a finding, if the file cannot be read. Sources and findings must outlive the
  /// reader: a line that is not a record is a finding at its place.
  static std::optional<RecordReader> Open(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings);

  enum class Outcome { kRecord, kBadLine, kEnd, kUnreadable };
  /// Replaces `record` with the one on the next line. A bad line is only a finding; the next call
  /// continues with the line after it. Beyond kMaxBadLines, bad lines are only counted. Where the
  /// file cannot be read on, there is a finding.
  Outcome Next(Record& record);
  static constexpr std::uint64_t kMaxBadLines = 50;
  std::uint64_t bad_lines() const { return bad_lines_; }

  /// The last line: its number, from 1 up, and its text without the end.
  std::uint32_t number() const { return number_; }
  const std::string& text() const { return text_; }
  /// Whether that line has no line end, because it was still being written.
  bool torn() const { return lines_.torn(); }
  /// The place of that line, for further findings about it.
  diag::SourceMark Mark() const;

 private:
  RecordReader(bytes::LineReader lines, std::string name, diag::Sources& sources,
               diag::Findings& findings);

  bytes::LineReader lines_;
  std::string name_;
  diag::Sources* sources_;
  diag::Findings* findings_;
  std::string text_;
  std::uint32_t number_ = 0;
  std::uint64_t bad_lines_ = 0;
};

/// How `record` differs from one of the same batch, in words: "seed is '7', not
/// '3'". Empty: both come from one command, whatever their indices.
std::string DifferenceOfBatch(const Record& record, const Record& other);

/// schemas/manifest.schema.json.
std::string ManifestSchema();

}  // namespace mjforge::manifest
