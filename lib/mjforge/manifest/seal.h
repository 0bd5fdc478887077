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

/// A file as it was when its batch was done.
struct SealedFile {
  std::string file;  // beside the seal
  bytes::Prefix content;
};

/// What vouches for a batch that is done, or for one shard of it: which variants there must be, and
/// size and checksum of its manifest and its archives. (Each object's hash is in its record.) It
/// stands beside the manifest and gets its name just before it.
struct Seal {
  /// What shapes the output and no record says: --name as it was given, the archive's name with its
  /// %05d (empty: a folder), and --per-archive (0: not a series).
  std::string name;
  std::string output;
  std::uint64_t per_archive = 0;
  /// As the records have it.
  std::string spec;
  /// The whole batch.
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  /// The part of it that was made, and its records.
  std::uint64_t shard = 0;
  std::uint64_t shards = 1;
  std::uint64_t records = 0;
  SealedFile manifest;
  std::vector<SealedFile> archives;
  /// What the objects refer to: name in them, SHA-256 of the bytes.
  std::map<std::string, std::string> assets;
};

/// "out/manifest.jsonl" -> "out/manifest.seal.json".
std::filesystem::path SealPathOf(const std::filesystem::path& manifest);

/// One line of JSON, with its end.
std::string SealText(const Seal& seal);
/// Nothing, and why, if the text is not a seal.
std::optional<Seal> ReadSeal(std::string_view text, std::string& why_not);

/// How two seals differ in what shapes the output, in words: "per_archive is '10', not '20'".
/// Empty: they do not.
std::string DifferenceOfOutput(const Seal& seal, const Seal& other);

}  // namespace mjforge::manifest
