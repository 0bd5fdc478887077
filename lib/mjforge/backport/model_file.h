// Reads and loads MJCF files, backported to the MuJoCo of this build if they need it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/backport/later_rules.h"
#include "mjforge/diag/diag.h"
#include "mjforge/engine/engine.h"

namespace mjforge::backport {

/// An MJCF file that was read by ReadModelFile().
struct ModelFile {
  std::uint32_t source = 0;  // the file's number in Sources
  bool has_includes = false;
  /// The backported text, in which included files replace the `<include>` elements; nullopt if the
  /// file needs no change.
  std::optional<std::string> backported;
  /// Elements that this MuJoCo would compile differently from later releases; none if the file
  /// needs a later MuJoCo.
  RuleDifferences differences;
};

/// Reads a file or standard input into `sources`. Returns nullopt and adds a finding if the file is
/// not MJCF or needs a later MuJoCo. Adds a warning for each feature that is removed.
std::optional<ModelFile> ReadModelFile(const std::filesystem::path& file, diag::Sources& sources,
                                       diag::Findings& findings);

/// Returns the backported text of a file. The text has absolute file names, and can be loaded from
/// any folder. Returns nullopt if the file needs no change, or cannot be read.
std::optional<std::string> BackportedText(const std::filesystem::path& file);

/// Reads and loads a file or standard input. If the file cannot be read or needs a later MuJoCo,
/// the load's error is the first error found.
engine::Loaded LoadFile(engine::Engine& engine, const std::filesystem::path& file);
/// Loads a file that ReadModelFile() read before; `read` is the result.
engine::Loaded LoadFile(engine::Engine& engine, const std::filesystem::path& file,
                        const ModelFile& read);

}  // namespace mjforge::backport
