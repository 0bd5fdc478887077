// A spec with the texts of all files that it was read from, so that it can be loaded again without
// them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::spec {

struct YamlNode;

/// Answers of the file system to the loads of a spec. A load with a snapshot takes the files and
/// texts that the snapshot has from there, reads all others, and adds them.
struct Snapshot {
  using Texts = std::map<std::filesystem::path, std::string>;

  std::string spec;                   // reference of the spec; "-": the text of `texts["-"]`
  std::string text_name = "<stdin>";  // name of that text in findings
  std::filesystem::path folder;       // base of relative paths; empty: the working folder
  std::vector<std::filesystem::path> search_path;
  /// The file of each reference, by the absolute folder of the referring file.
  std::map<std::pair<std::filesystem::path, std::string>, std::filesystem::path> found;
  Texts texts;  // by canonical path
  /// Parameter files (LoadOptions::parameter_files), by canonical path. Apart from `texts`, because
  /// other parameter files may be given with a snapshot that was written beside a batch.
  Texts parameter_texts;
  /// Parsed texts, by the same paths; not saved.
  std::map<std::filesystem::path, std::shared_ptr<const YamlNode>> parsed;
};

/// Returns the snapshot as one line of JSON with its line end. All paths are absolute.
std::string SnapshotText(const Snapshot& snapshot);

/// Number of bytes at the start of a text that IsSnapshot needs.
inline constexpr std::size_t kSnapshotHead = 22;

/// Returns true for the start of a text that SnapshotText made.
bool IsSnapshot(std::string_view start);

/// Parses a text that SnapshotText made; returns nothing if the text is damaged.
std::optional<Snapshot> ReadSnapshot(std::string text);

/// Returns the snapshot that `reference`, a file or standard input ("-"), contains. Returns nothing
/// if `reference` is anything else; then a finding is added only if the snapshot is damaged. The
/// snapshot of a file has no parameter files, because the settings of its batch are in the records.
std::optional<Snapshot> OpenSnapshot(const std::string& reference, diag::Findings& findings);

}  // namespace mjforge::spec
