#pragma once

// Bytes -> files, folders and archives. A file appears whole or not at all.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/output/archive.h"
#include "mjforge/output/destination.h"
#include "mjforge/output/part_file.h"

namespace mjforge::output {

/// What may happen to files that are there already.
struct OverwritePolicy {
  bool force = false;       // replace files that mjforge did not make
  bool if_changed = false;  // leave a file that has the same bytes untouched, with its time
  // Of assets, which may already be there when the batch is continued.
  Durability durability = Durability::kNone;
  // SHA-256 of assets that others may replace: an older run of the same batch made them.
  std::set<std::string> assets = {};
};

/// Writes beside the file and renames. On failure nothing is left and a finding
/// is added. The folder must exist. With `if_changed` a file with these bytes is
/// left as it is.
bool WriteFile(const std::filesystem::path& file, std::string_view bytes, bool if_changed,
               diag::Findings& findings, Durability durability = Durability::kNone);

/// The whole content of a file; nothing and a finding if it cannot be read or has more than `limit`
/// bytes.
std::optional<std::string> ReadFile(const std::filesystem::path& file, std::uint64_t limit,
                                    diag::Findings& findings);

/// Whether `file` may get other bytes: it is not there, `is_ours` says so of its first bytes, or
/// `force`. A pipe or a device never may. False, and a finding, if it may not.
bool MayReplace(const std::filesystem::path& file, bool force, std::size_t bytes,
                const std::function<bool(std::string_view)>& is_ours, diag::Findings& findings);

/// True if nothing would be lost by writing `file`: it does not exist, it is an object that mjforge
/// wrote or the beginning of one (a power cut may leave nothing but zeros), or `force` says so.
/// Else a finding.
bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings);

/// Adds "'FILE' exists and was not made by mjforge".
void AddForeignFile(const std::filesystem::path& file, diag::Findings& findings);

/// Folders made for a batch; the destructor removes those still empty.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  ~MadeFolders();

  /// Makes the folder and those above it that are missing.
  bool Make(const std::filesystem::path& folder, diag::Findings& findings);
  /// The same for a folder below one that is there; there, links to other places are refused.
  bool MakeBelow(const std::filesystem::path& base, const std::filesystem::path& folder,
                 diag::Findings& findings);

 private:
  bool MakeOne(const std::filesystem::path& path, bool follow, diag::Findings& findings);

  std::vector<std::filesystem::path> made_;  // outermost first
};

/// Adds "'NAME' was changed while the batch was made".
void AddAssetChanged(const std::string& name, diag::Findings& findings);

/// Names of assets in a document, and the SHA-256 of their bytes.
using AssetHashes = std::vector<std::pair<std::string, std::string>>;

/// The content of an asset's file; nothing, and a finding, if it cannot be read or, unless `sha256`
/// is empty, has another hash.
std::optional<std::string> ReadAsset(const std::filesystem::path& file, const std::string& sha256,
                                     diag::Findings& findings);

/// Objects in a folder with the assets they need. Several processes may fill one
/// folder at the same time, with different files.
class ObjectFolder {
 public:
  ObjectFolder(std::filesystem::path folder, const OverwritePolicy& overwrite)
      : folder_(std::move(folder)), overwrite_(overwrite) {}

  /// Writes one object's file (its name may have folders in it, which are made) and, before it, its
  /// assets beside it, each once. Existing files that mjforge did not make are replaced only as
  /// `overwrite` says. An asset whose bytes do not have the hash that `hashes` has for its name
  /// (manifest::Record::assets) was changed in the meantime, which is a finding.
  bool Write(const std::string& file, const mjcf::MjcfDocument& document, diag::Findings& findings,
             const AssetHashes& hashes = {});

 private:
  bool CopyAssets(const mjcf::MjcfDocument& document, const std::filesystem::path& folder,
                  const AssetHashes& hashes, diag::Findings& findings);
  bool CopyAsset(const bytes::Asset& asset, const std::filesystem::path& target,
                 const std::string& sha256, diag::Findings& findings) const;

  std::filesystem::path folder_;
  OverwritePolicy overwrite_;
  MadeFolders folders_;
  std::filesystem::path last_folder_;       // that the last file went to
  std::set<std::filesystem::path> assets_;  // done
};

/// Removes what killed processes left half-written in a folder: hidden files whose final names
/// `is_ours` accepts and that no living process has. With `below`, in its subfolders, too.
void RemoveAbandoned(const std::filesystem::path& folder, bool below,
                     const std::function<bool(const std::string&)>& is_ours);

/// "hammer_000042.xml" -> 42; nothing for other names.
std::optional<std::uint64_t> IndexOfFile(std::string_view file);

/// "TARGETS: FILES" for Make, as compilers write it for -MF: one file per line, with spaces, # and
/// $ escaped. Targets are written as given. With `phony` each file is also a target, so that Make
/// continues when it is gone.
std::string MakeRule(std::span<const std::string> targets, const std::set<std::string>& files,
                     bool phony);
/// A target's name as a rule needs it.
std::string EscapeForMake(std::string_view name);

}  // namespace mjforge::output
