// Destinations of a batch: parsing of -o, and the names of objects, archives and manifests.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/output/archive.h"

namespace mjforge::output {

/// A part of a batch that is divided among several commands; `index` counts from 0.
struct Shard {
  std::uint64_t index = 0;
  std::uint64_t count = 1;

  bool IsWhole() const { return count == 1; }
  /// Returns the end of the shard's file names, before the extension: "-00003-of-00008"; empty for
  /// a whole batch.
  std::string Suffix() const;
};

/// Destination of a batch.
struct Destination {
  enum class Kind { kNowhere, kFolder, kFile, kStandardOutput, kArchive, kArchives, kFamily };

  Kind kind = Kind::kNowhere;
  /// Path as given on the command line. For kArchives, the path contains %05d for the archive's
  /// number; for kFamily, it may contain %s for the key of the structure.
  std::filesystem::path path;
  ArchiveFormat format = ArchiveFormat::kTar;
  std::uint64_t per_archive = 0;  // kArchives: number of variants in each archive

  /// Returns true if each output file contains many variants: an archive, a series of archives, or
  /// families.
  bool PacksVariants() const {
    return kind == Kind::kArchive || kind == Kind::kArchives || kind == Kind::kFamily;
  }
  bool HasManifest() const { return kind == Kind::kFolder || PacksVariants(); }
  /// Returns true for a file of one variant and for standard output.
  bool TakesOne() const { return kind == Kind::kFile || kind == Kind::kStandardOutput; }
  /// Returns the path of archive `number`, counted from 0, of a series; for a single archive, its
  /// path.
  std::filesystem::path Archive(std::uint64_t number) const;
  /// Returns true if the variants of each structure (structure.h) form a family of their own:
  /// NAME_%s.npz.
  bool IsSplit() const;
  /// Returns the path of the family for the structure with this key; if there is a single family,
  /// its path.
  std::filesystem::path Family(std::string_view key) const;
  /// Returns the path of the file with the rows of a family, one row per variant. For a shard:
  /// NAME-00003-of-00008.rows, which `mjforge merge` joins with the rows of other shards. For a
  /// whole family: NAME.rows, which exists only while the family is made.
  std::filesystem::path Rows(const Shard& shard) const;
  /// Returns the path of the manifest: DIR/manifest.jsonl for a folder, STEM.manifest.jsonl beside
  /// archives, STEM.manifest.jsonl.zst beside compressed archives; with "-00003-of-00008" before
  /// the extension for a shard.
  std::filesystem::path Manifest(const Shard& shard) const;
  /// Returns the folder of the manifest.
  std::filesystem::path Folder() const;
};

/// Returns true for the name of a manifest, compressed or not.
bool IsManifestName(std::string_view name);
/// Returns true for the file name of a manifest, complete or partial (".part").
bool IsManifest(std::string_view name);
/// Returns the manifest of the batch that `what` names by its folder, its manifest, or an archive,
/// series or family; nullopt if `what` cannot be the name of a batch.
std::optional<std::filesystem::path> ManifestOf(const std::string& what);

/// Parses the argument of -o: "-", FILE.xml, FILE.npz, FILE.tar or FILE.tar.zst (a series if the
/// name has one %d or %05d; a family per structure if it has one %s); any other text is a folder.
/// Returns nullopt, and the reason in `why_not`, if the text is not valid.
std::optional<Destination> ParseDestination(std::string_view text, std::uint64_t per_archive,
                                            std::string& why_not);

/// Returns the name of variant `index`, "hammer_000042": its file's name without the extension.
std::string VariantStem(std::string_view name, std::uint64_t index);

/// Parses a text of decimal digits, "000042"; returns nullopt if it is not a number.
std::optional<std::uint64_t> ReadIndex(std::string_view digits);

/// Number of variants whose files share a folder. Each further group of this size gets a subfolder.
/// The path of a file therefore depends only on its index.
inline constexpr std::uint64_t kFilesPerFolder = 10'000;
/// Endings of a variant's file name, appended to VariantStem(). An object has a single file. A
/// scene whose objects have files of their own (--each) has a folder with these files and its
/// placement.
inline constexpr std::string_view kObjectEnding = ".xml";
inline constexpr std::string_view kPlacementEnding = "/placement.json";
/// Returns the path of a variant's file within the folder: "hammer_000042.xml",
/// "0020000/hammer_023456.xml".
std::string PathInFolder(std::string_view name, std::uint64_t index,
                         std::string_view ending = kObjectEnding);

}  // namespace mjforge::output
