// Snapshot of a spec: the texts of all files from which the spec was loaded. With a snapshot, the
// spec can be loaded again without the files.
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

/// Files and texts that were read while a spec was loaded. A load with a snapshot takes files and
/// texts from the snapshot, and adds to the snapshot the files that are missing there.
struct Snapshot {
  using Texts = std::map<std::filesystem::path, std::string>;

  std::string spec;                   // path or name of the spec; "-": the spec is `texts["-"]`
  std::string text_name = "<stdin>";  // name of the text `texts["-"]` in findings
  std::filesystem::path folder;       // base of relative paths; empty: the working folder
  std::vector<std::filesystem::path> search_path;
  /// Results of searches for files. The key is the absolute folder of the referring file, and the
  /// reference (path or name) in that file.
  std::map<std::pair<std::filesystem::path, std::string>, std::filesystem::path> found;
  Texts texts;  // text of each file; the key is the canonical path
  /// Texts of parameter files (LoadOptions::parameter_files), by canonical path. Not part of
  /// `texts`, because a snapshot that was written beside a batch may be used with other parameter
  /// files.
  Texts parameter_texts;
  /// Parsed texts, by the same paths as in `texts`. SnapshotText() does not write them.
  std::map<std::filesystem::path, std::shared_ptr<const YamlNode>> parsed;
};

/// Returns the snapshot as one line of JSON with its line end. The text contains the path of the
/// working folder if `folder` is empty.
std::string SnapshotText(const Snapshot& snapshot);

/// Number of bytes that IsSnapshot() needs from the start of a text.
inline constexpr std::size_t kSnapshotHead = 22;

/// Returns true if `start` is the start of a text that SnapshotText() made.
bool IsSnapshot(std::string_view start);

/// Parses a text that SnapshotText() made. Returns nullopt if the text is damaged.
std::optional<Snapshot> ReadSnapshot(std::string text);

/// Reads the snapshot in `reference`, a file NAME.json or standard input ("-"). Returns nullopt if
/// `reference` does not contain a snapshot and, after adding a finding, if the snapshot is damaged.
/// Removes the texts of parameter files from a snapshot that is read from a file, because the
/// settings of the batch that wrote the file are in the records of the batch.
std::optional<Snapshot> OpenSnapshot(const std::string& reference, diag::Findings& findings);

}  // namespace mjforge::spec
