#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/output/archive.h"

namespace mjforge::output {

/// One part of a batch that several commands make: `index` counts from 0.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;

  bool IsWhole() const { return count == 1; }
};

/// Where a batch goes.
struct Destination {
  enum class Kind { kNowhere, kFolder, kFile, kStandardOutput, kArchive, kArchives };

  Kind kind = Kind::kNowhere;
  std::filesystem::path path;  // of archives in a series: with %05d for the number
  ArchiveFormat format = ArchiveFormat::kTar;
  std::uint64_t per_archive = 0;  // variants in each archive of a series

  bool IsArchive() const { return kind == Kind::kArchive || kind == Kind::kArchives; }
  /// The file of archive `number` of a series, counted from 0; for a single archive, its file.
  std::filesystem::path Archive(std::uint64_t number) const;
  /// For a folder DIR/manifest.jsonl, for archives STEM.manifest.jsonl beside them; for a shard
  /// with "-00003-of-00008" before the ending.
  std::filesystem::path Manifest(const Shard& shard) const;
  /// The folder that holds the manifest.
  std::filesystem::path Folder() const;
};

/// The destination that `-o text` names: "-", FILE.xml, FILE.tar or FILE.tar.zst (a series with one
/// %d or %05d in its name), else a folder. Nothing, and why, if the text is not valid.
std::optional<Destination> ParseDestination(std::string_view text, std::uint64_t per_archive,
                                            std::string& why_not);

/// The name of variant `index`, "hammer_000042"; with .xml, the name of its file.
std::string VariantStem(std::string_view name, std::uint64_t index);

/// The number that all of `digits` spells, "000042"; nothing if it is none.
std::optional<std::uint64_t> ReadIndex(std::string_view digits);

/// A folder holds at most this many files; further files go to subfolders, so that a file's place
/// depends on its index alone.
inline constexpr std::uint64_t kFilesPerFolder = 10'000;
/// "hammer_000042.xml", "0020000/hammer_023456.xml".
std::string PlaceInFolder(std::string_view name, std::uint64_t index);

}  // namespace mjforge::output
