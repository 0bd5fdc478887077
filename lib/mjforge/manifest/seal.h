// The seal of a finished batch or shard: sizes and checksums of its manifest and archives.

#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/bytes/bytes.h"

namespace mjforge::manifest {

/// Size and checksum that a file had when its batch was finished.
struct SealedFile {
  std::string file;  // name in the folder of the seal
  bytes::Fingerprint content;
};

/// Certificate of a finished batch, or of one shard: the range of its variants, and size and
/// checksum of its manifest and archives. Hashes of objects are in the records. The file of the
/// seal is beside the manifest and gets its final name just before the manifest does.
struct Seal {
  /// Options that determine the output but are not in records. `name` is --name; `output` is the
  /// archive's name with its %05d (empty: a folder); `per_archive` is --per-archive (0: no series).
  std::string name;
  std::string output;
  std::uint64_t per_archive = 0;
  /// Record::spec of all records.
  std::string spec;
  /// Index range of the whole batch, of which this seal may describe a shard.
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  /// The shard that this seal describes, and the number of its records.
  std::uint64_t shard = 0;
  std::uint64_t shards = 1;
  std::uint64_t records = 0;
  SealedFile manifest;
  std::vector<SealedFile> archives;
  /// SHA-256 of each asset, by the name that the asset has in the objects' MJCF.
  std::map<std::string, std::string> assets;
};

/// Returns the path of a manifest's seal: "out/manifest.seal.json" for "out/manifest.jsonl" and for
/// "out/manifest.jsonl.zst".
std::filesystem::path SealPathOf(const std::filesystem::path& manifest);

/// Maximum size of a seal in bytes. No seal is so large, because a folder cannot contain enough
/// archives.
inline constexpr std::uint64_t kMaxSeal = std::uint64_t{64} << 20;

/// Returns the seal as one line of JSON, with the line end.
std::string SealText(const Seal& seal);
/// Parses a seal; returns nullopt, and the reason in `why_not`, if the text is not a valid seal.
std::optional<Seal> ReadSeal(std::string_view text, std::string& why_not);

/// Returns the seal beside a manifest; nullopt, and the reason in `why_not`, if the seal is missing
/// or damaged.
std::optional<Seal> ReadSealBeside(const std::filesystem::path& manifest, std::string& why_not);

/// Describes the first output option in which two seals differ: "per_archive is '10', not '20'".
/// Empty if all output options are equal.
std::string DifferenceOfOutput(const Seal& seal, const Seal& other);

}  // namespace mjforge::manifest
