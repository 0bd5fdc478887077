#ifndef MJFORGE_OUTPUT_OUTPUT_H_
#define MJFORGE_OUTPUT_OUTPUT_H_

// Files and the manifest. A file appears whole or not at all.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/sample/sample.h"

namespace mjforge::output {

/// SHA-256 in hexadecimal.
std::string Sha256(std::string_view bytes);

/// Writes beside the file and renames. On failure nothing is left and a finding
/// is added. The folder must exist.
bool WriteFile(const std::filesystem::path& file, std::string_view bytes, diag::Findings& findings);

/// The whole content of a file; nothing and a finding if it cannot be read.
std::optional<std::string> ReadFile(const std::filesystem::path& file, diag::Findings& findings);

/// True if nothing would be lost by writing `file`: it does not exist, it is an
/// object that mjforge wrote, or `force` says so. Else a finding.
bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings);

/// One line of manifest.jsonl: what was made, from what, and what it weighs.
struct Record {
  std::string file;  // relative to the manifest; empty: none was written
  std::string name;
  std::uint64_t index = 0;
  std::uint64_t seed = 0;
  std::uint64_t attempt = 0;
  std::string spec;
  std::string spec_sha256;
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::pair<std::string, sample::ParameterValue>> params;
  model::MassProperties mass_properties;
  model::Bounds bounds;
  // As MuJoCo counts them in the file. nbody counts the world; 0: no object was
  // made, and masses, bounds and counts mean nothing.
  int nbody = 0;
  int njnt = 0;
  int ngeom = 0;
  std::string target;
  std::string sampler;                // empty: random
  std::uint64_t batch = 0;            // items of the batch; 0: no matter
  std::string status;                 // "ok", "failed", "skipped"
  std::vector<std::string> findings;  // JSON objects, as diag::RenderJson makes them
  std::string sha256;                 // of the file's bytes; empty: none was written
};
/// Appends one JSON object and a line end.
void AppendRecord(std::string& out, const Record& record);
/// Reads back what replay needs: file name index seed attempt spec spec_sha256
/// settings target sampler batch status sha256. Nothing, and why, if the line is not a record.
std::optional<Record> ReadRecord(std::string_view line, std::string& why_not);

/// schemas/manifest.schema.json.
std::string ManifestSchema();

/// `name_000042.xml`.
std::string VariantFileName(std::string_view name, std::uint64_t index);

/// A folder of variants: files, assets/ and manifest.jsonl.
class DirectoryWriter {
 public:
  /// Makes the folder if needed. Refuses one whose manifest we did not make,
  /// unless `force`. Nothing and a finding on failure.
  static std::optional<DirectoryWriter> Open(const std::filesystem::path& folder, bool force,
                                             diag::Findings& findings);

  DirectoryWriter(DirectoryWriter&&) noexcept;
  DirectoryWriter& operator=(DirectoryWriter&&) noexcept;
  /// Without Finish the manifest is dropped, and the folder too if it was made
  /// here and is empty.
  ~DirectoryWriter();

  /// Writes one variant's file and the assets it needs (each once). Refuses to
  /// replace a file that we did not make, unless `force`.
  bool Write(const std::string& file, const mjcf::MjcfDocument& document, diag::Findings& findings);
  /// Adds a line to the manifest that Finish() will show.
  bool Add(const Record& record, diag::Findings& findings);
  /// Gives the manifest its name.
  bool Finish(diag::Findings& findings);

 private:
  struct State;
  explicit DirectoryWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Copies a document's assets beside a single output file. One that is there
/// already with the same content is left alone; other content is only replaced
/// with `force`.
bool CopyAssets(const mjcf::MjcfDocument& document, const std::filesystem::path& folder, bool force,
                diag::Findings& findings);

/// Writes one object's file with its assets beside it; missing folders are made.
/// Files that are there and were not made by mjforge, and assets with other
/// content, are only replaced with `force`.
bool WriteObject(const std::filesystem::path& file, const mjcf::MjcfDocument& document, bool force,
                 diag::Findings& findings);

}  // namespace mjforge::output

#endif  // MJFORGE_OUTPUT_OUTPUT_H_
