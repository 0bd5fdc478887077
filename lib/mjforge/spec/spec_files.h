// Files that a spec consists of: the spec itself, nested specs, imports and tables.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

/// Returns the canonical path of a file, or `file` itself if the path cannot be resolved.
std::filesystem::path Canonical(const std::filesystem::path& file);

/// Returns the file that `reference` names in `folder` or in the search path of the options. Looks
/// in the options' snapshot first, then on the disk. Returns nullopt if there is no such file.
std::optional<std::filesystem::path> FindFile(const std::string& reference,
                                              const std::filesystem::path& folder,
                                              const LoadOptions& options);

/// Reads a file, adds its text to `sources` and returns the number of the text in `sources`. If
/// `snapshot` is not null and its map `held_texts` contains the file, takes the text from the map.
/// Otherwise reads the disk, and adds the text to the map. Returns nullopt, and adds a finding that
/// contains `name`, if reading fails.
std::optional<std::uint32_t> ReadSource(const std::filesystem::path& file, std::string_view name,
                                        diag::SourceMark mark, Snapshot* snapshot,
                                        diag::Sources& sources, diag::Findings& findings,
                                        Snapshot::Texts Snapshot::*held_texts = &Snapshot::texts);

class SpecFiles {
 public:
  /// `first` is the spec's own file, whose text is number `source` in `sources`. `options`,
  /// `sources` and `findings` must outlive this object.
  SpecFiles(const LoadOptions& options, const std::filesystem::path& first, std::uint32_t source,
            diag::Sources& sources, diag::Findings& findings)
      : options_(options),
        sources_(sources),
        findings_(findings),
        files_{first},
        source_ids_{source} {}

  /// Returns the file that `reference` names; nullopt, after adding a finding, if there is none.
  std::optional<std::filesystem::path> Find(const std::string& reference,
                                            const std::filesystem::path& folder,
                                            diag::SourceMark mark);
  /// Returns true, and adds a finding, if the file is being read already, because it refers to
  /// itself, directly or through other files.
  bool IsOpen(const std::filesystem::path& file, diag::SourceMark mark);
  /// Reads the file unless it was read before, and returns its number in diag::Sources. Returns
  /// nullopt, and adds a finding, if reading fails.
  std::optional<std::uint32_t> Open(const std::filesystem::path& file, diag::SourceMark mark);
  /// Parses the file, whose text is number `source` in diag::Sources. Returns nullopt, after adding
  /// findings, if the text is not valid YAML.
  std::optional<YamlNode> Parse(const std::filesystem::path& file, std::uint32_t source);

  /// Marks a file as being read during the lifetime of this object.
  class OpenScope {
   public:
    OpenScope(SpecFiles& files, const std::filesystem::path& file) : files_(files) {
      files_.open_.push_back(file);
    }
    ~OpenScope() { files_.open_.pop_back(); }
    OpenScope(const OpenScope&) = delete;
    OpenScope& operator=(const OpenScope&) = delete;

   private:
    SpecFiles& files_;
  };
  std::size_t depth() const { return open_.size(); }

  /// All files read so far, in the order in which they were first read.
  const std::vector<std::filesystem::path>& all() const { return files_; }
  /// Returns the SHA-256, in hexadecimal, of the concatenated texts of all files in the order of
  /// all().
  std::string Sha256() const;

 private:
  const LoadOptions& options_;
  diag::Sources& sources_;
  diag::Findings& findings_;
  std::vector<std::filesystem::path> open_;  // files that are being read, outermost first
  std::vector<std::filesystem::path> files_;
  std::vector<std::uint32_t> source_ids_;  // number of each file of `files_` in diag::Sources
};

}  // namespace mjforge::spec
