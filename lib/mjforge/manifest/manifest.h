// The records of a batch's manifest: one line of JSON per variant, written, read and compared.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/manifest/choices.h"
#include "mjforge/manifest/columns.h"
#include "mjforge/manifest/placement.h"
#include "mjforge/manifest/seal.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/sample/sample.h"

namespace mjforge::manifest {

/// The number of variants with each status.
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

/// A line of manifest.jsonl: provenance and result of a variant. The name is always set, in
/// contrast to the provenance in the variant's file.
struct Record : mjcf::Provenance {
  std::string file;       // path from the manifest's folder or in the archive; empty: no file
  std::string archive;    // path from the manifest's folder; empty: not in an archive
  std::string spec_file;  // path from the manifest's folder; empty: spec found by name, or unknown
  std::uint64_t attempt = 0;
  std::vector<std::pair<std::string, sample::ParameterValue>> params;
  model::MassProperties mass_properties;
  model::Bounds bounds;
  // Counts of elements in MuJoCo's model of the file. nbody includes the world; if nbody is 0, no
  // object was made, and masses, bounds and counts are meaningless.
  int nbody = 0;
  int njnt = 0;
  int ngeom = 0;
  /// A body that `place:` placed: its name in the file, the region or site as in the spec, and its
  /// pose in the world at the start.
  struct PlacedBody {
    std::string body;
    std::string at;
    Eigen::Vector3d pos = Eigen::Vector3d::Zero();  // m
    std::vector<double> quat;                       // w x y z
  };
  std::vector<PlacedBody> places;
  std::string pile_mujoco;            // release of MuJoCo that settled the piles; empty: no piles
  std::vector<std::string> left_out;  // bodies without room, left out by `fewer: true`
  Validation validate = Validation::kLoad;
  std::string mujoco;     // release of MuJoCo that checked the variant; empty: not checked
  std::string structure;  // key of the structure (structure.h); empty: not loaded in MuJoCo
  Layout layout = Layout::kAny;
  std::optional<std::uint64_t> layout_first;  // index of the batch's first variant (kOne, pad)
  /// Padding of a family (--pad): number of variants, from layout_first on, whose geoms and sites
  /// every variant of the family has; 0: no padding.
  std::uint64_t pad = 0;
  bool mocap = false;  // in the family's base model, fixed bodies are mocap bodies
  std::optional<physics::Result> physics;  // empty if not requested or not measurable
  OnInvalid on_invalid = OnInvalid::kFail;
  Status status = Status::kOk;
  std::vector<std::string> findings;  // JSON objects made by diag::RenderJson
  /// True if each object of the scene has a file of its own: `file` is then the placement, and the
  /// objects are among the assets. Masses, bounds and counts are those of the whole scene.
  bool each = false;
  std::string sha256;  // hash of the file; empty: no file was written
  // Assets that the file refers to: name in the file, SHA-256 of the asset.
  std::vector<std::pair<std::string, std::string>> assets;

  /// Returns the folder of the variant's structure, "0123456789ab/", for Layout::kSplit; otherwise
  /// "".
  std::string Folder() const {
    return layout == Layout::kSplit && !structure.empty() ? structure + "/" : std::string();
  }
};

/// Appends the record as one JSON object, and a line end.
void AppendRecord(std::string& out, const Record& record);

/// Appends `line`, which AppendRecord wrote without `archive` and `spec_file`, with these two
/// members inserted unless they are empty.
void AppendWithPaths(std::string& out, std::string_view line, const std::string& archive,
                     const std::string& spec_file);

/// Returns a physics result as a JSON object, the value of the record's member `physics`.
std::string PhysicsJson(const physics::Result& result);

/// Returns the record of a line; nullopt, and the reason in `why_not`, if the line is not a record.
std::optional<Record> ReadRecord(std::string_view line, std::string& why_not);

/// Returns the offsets at which a manifest can be divided into sections, for reading parts of it
/// (bytes::CutsOf). Returns nullopt, after adding a finding, if the file cannot be read.
std::optional<std::vector<std::uint64_t>> CutsOf(const std::filesystem::path& file,
                                                 diag::Findings& findings);

/// Reads the records of a manifest one after the other, in constant memory, because a manifest may
/// have a hundred million lines.
class RecordReader {
 public:
  /// Returns a reader; nullopt, after adding a finding, if the file cannot be read. Sources and
  /// findings must outlive the reader, because Next() adds findings. If `section` is a part of the
  /// file, lines are counted from the start of the section.
  static std::optional<RecordReader> Open(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings,
                                          const bytes::FileSection& section = {});

  enum class Outcome { kRecord, kBadLine, kEnd, kUnreadable };
  /// Replaces `record` with the record on the next line. After kBadLine (the line is not a record),
  /// the next call continues with the following line. Adds a finding for each of the first
  /// kMaxBadLines bad lines. Returns kUnreadable, after adding a finding, if reading fails or if
  /// more than kMaxSkippedLines lines are bad.
  Outcome Next(Record& record);
  static constexpr std::uint64_t kMaxBadLines = 50;
  /// Maximum number of lines that are not records. A small compressed file can contain thousands of
  /// millions of such lines.
  static constexpr std::uint64_t kMaxSkippedLines = 1'000'000;

  /// Number of the last line read, counted from 1.
  std::uint32_t number() const { return number_; }
  /// Returns true if the last line read has no line end or, in a compressed file, the last frame is
  /// incomplete, because it was still being written.
  bool is_truncated() const { return lines_.is_truncated(); }
  /// Returns the place of the last line read, for further findings about that line.
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

/// Returns the record with this index; nullopt, after adding a finding, if there is none. Bisects a
/// manifest in index order. If bisection does not find the record, reads the whole manifest, unless
/// all lines read are good and a seal shows that the manifest is complete.
std::optional<Record> FindRecord(const std::filesystem::path& file, std::uint64_t index,
                                 diag::Sources& sources, diag::Findings& findings);

/// Describes the first difference that shows that two records belong to different batches: "seed is
/// '7', not '3'". Empty if the records can come from one command.
std::string DifferenceOfBatch(const Record& record, const Record& other);

/// Returns the JSON Schema of a record, the text of schemas/manifest.schema.json.
std::string ManifestSchema();

}  // namespace mjforge::manifest
