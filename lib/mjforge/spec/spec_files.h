#pragma once

// Private to the room: the files that a spec is made of.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::spec {

class SpecFiles {
 public:
  /// `first` is the spec's own, read already. All but `first` must outlive this.
  SpecFiles(std::span<const std::filesystem::path> search_path, const std::filesystem::path& first,
            std::uint32_t source, diag::Sources& sources, diag::Findings& findings)
      : search_path_(search_path),
        sources_(sources),
        findings_(findings),
        files_{first},
        source_ids_{source} {}

  /// The spec that `reference` names; nothing, and a finding, if there is none.
  std::optional<std::filesystem::path> Find(const std::string& reference,
                                            const std::filesystem::path& folder,
                                            diag::SourceMark mark);
  /// Whether it is being read, so that it refers to itself; that is a finding.
  bool IsOpen(const std::filesystem::path& file, diag::SourceMark mark);
  /// Reads it unless it was read; its number among the sources. Nothing, and a finding, if it
  /// cannot be read.
  std::optional<std::uint32_t> Open(const std::filesystem::path& file, diag::SourceMark mark);

  /// A file is being read as long as this is there.
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

  /// In order of first reading.
  const std::vector<std::filesystem::path>& all() const { return files_; }
  /// Of all their texts, one after the other; hexadecimal.
  std::string Sha256() const;

 private:
  std::span<const std::filesystem::path> search_path_;
  diag::Sources& sources_;
  diag::Findings& findings_;
  std::vector<std::filesystem::path> open_;  // specs and imports being read, outermost first
  std::vector<std::filesystem::path> files_;
  std::vector<std::uint32_t> source_ids_;  // of `files_`
};

}  // namespace mjforge::spec
