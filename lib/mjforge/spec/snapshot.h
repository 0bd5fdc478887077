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

/// Files and texts that loads of a spec have read. A load with a snapshot takes files and texts
/// from the snapshot if they are in it, and reads and adds the others.
struct Snapshot {
  using Texts = std::map<std::filesystem::path, std::string>;

  std::string spec;                   // reference of the spec; "-": the text of `texts["-"]`
  std::string text_name = "<stdin>";  // name of the text `texts["-"]` in findings
  std::filesystem::path folder;       // base of relative paths; empty: the working folder
  std::vector<std::filesystem::path> search_path;
  /// Files that references name; the key is the referring file's absolute folder and the reference.
  std::map<std::pair<std::filesystem::path, std::string>, std::filesystem::path> found;
  Texts texts;  // text of each file, by canonical path
  /// Parameter files (LoadOptions::parameter_files), by canonical path; not in `texts`,
  /// because other parameter files may be given with a snapshot that was written beside a batch.
  Texts parameter_texts;
  /// Parsed texts, by the same paths as in `texts`; not in SnapshotText().
  std::map<std::filesystem::path, std::shared_ptr<const YamlNode>> parsed;
};

/// Returns the snapshot as one line of JSON with its line end. All paths are absolute.
std::string SnapshotText(const Snapshot& snapshot);

/// Number of bytes at the start of a text that IsSnapshot needs.
inline constexpr std::size_t kSnapshotHead = 22;

/// Returns true for the start of a text that SnapshotText made.
bool IsSnapshot(std::string_view start);

/// Parses a text that SnapshotText() made; returns nullopt if the text is damaged.
std::optional<Snapshot> ReadSnapshot(std::string text);

/// Reads the snapshot in `reference`, a file or standard input ("-"). Returns nullopt if
/// `reference` contains anything else, or, after a finding, a damaged snapshot. Drops the parameter
/// files of a snapshot in a file, because the settings of its batch are in the records.
std::optional<Snapshot> OpenSnapshot(const std::string& reference, diag::Findings& findings);

}  // namespace mjforge::spec
