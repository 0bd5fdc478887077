// Writing of files, folders and archives; a file appears complete or not at all.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
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
#include "mjforge/output/npz.h"
#include "mjforge/output/part_file.h"

namespace mjforge::output {

/// Treatment of existing files.
struct OverwritePolicy {
  bool force = false;       // replace files that mjforge did not make
  bool if_changed = false;  // leave a file with the same bytes untouched, including its time
  // Durability (safety from power cuts) of copied assets, which a resumed batch does not write
  // again.
  Durability durability = Durability::kNone;
  // SHA-256 of assets that earlier runs of the same batch wrote. An existing file may be replaced
  // if its old or its new content has one of these hashes.
  std::set<std::string> assets = {};
  // Names and SHA-256 of assets that earlier objects refer to. An existing file with one of these
  // names may only be replaced by content with the hash given here.
  std::map<std::string, std::string> kept_assets = {};
};

/// Writes a temporary file beside `file` and renames it. On failure, removes the temporary file,
/// adds a finding and returns false. The folder must exist. With `if_changed`, a file that already
/// has these bytes stays untouched. With Durability::kBatch, waits until the bytes and the name are
/// on the disk.
bool WriteFile(const std::filesystem::path& file, std::string_view bytes, bool if_changed,
               diag::Findings& findings, Durability durability = Durability::kNone);

/// Returns the content of a file; nullopt, after adding a finding, if it cannot be read or has more
/// than `limit` bytes.
std::optional<std::string> ReadFile(const std::filesystem::path& file, std::uint64_t limit,
                                    diag::Findings& findings);

/// Returns true if `file` may be written: it does not exist, it is no link and `is_ours` accepts
/// its first `bytes` bytes, or `force` is set. Otherwise, and always for a pipe or a device, adds a
/// finding and returns false.
bool MayReplace(const std::filesystem::path& file, bool force, std::size_t bytes,
                const std::function<bool(std::string_view)>& is_ours, diag::Findings& findings);

/// Returns true if `file` may be replaced by an object with this text: accepts an object that
/// mjforge wrote, the remains of one after a power cut, and a damaged copy of `text`. Otherwise
/// adds a finding.
bool MayReplace(const std::filesystem::path& file, std::string_view text, bool force,
                diag::Findings& findings);

/// Returns true if `present` can be a damaged copy of `bytes`: a prefix, possibly followed by
/// zeros, the same number of bytes, of which at least half are equal, or all bytes, followed by
/// others.
bool IsDamagedCopy(std::string_view present, std::string_view bytes);

/// Folders made for a batch; the destructor removes those folders that are still empty.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  ~MadeFolders();

  /// Makes the folder and all missing folders above it. Returns false, after adding a finding, if
  /// that fails.
  bool Make(const std::filesystem::path& folder, diag::Findings& findings);
  /// Makes `folder` below the existing folder `base`. Below `base`, symbolic links are rejected.
  /// Returns false, after adding a finding, if that fails.
  bool MakeBelow(const std::filesystem::path& base, const std::filesystem::path& folder,
                 diag::Findings& findings);

 private:
  bool MakeAll(std::filesystem::path path, const std::filesystem::path& folder, bool follow,
               diag::Findings& findings);
  bool MakeOne(const std::filesystem::path& path, bool follow, diag::Findings& findings);

  std::vector<std::filesystem::path> made_;  // outermost first
};

/// Returns the entries of a folder (empty: the working folder); sets `error` if it cannot be read.
std::vector<std::filesystem::path> EntriesOf(const std::filesystem::path& folder,
                                             std::error_code& error);

/// Adds the finding "'NAME' was changed while the batch was made".
void AddAssetChanged(const std::string& name, diag::Findings& findings);

/// Pairs of an asset's name in a document and the SHA-256 of the asset.
using AssetHashes = std::vector<std::pair<std::string, std::string>>;

/// Returns the content of an asset's file; nullopt, after adding a finding, if the file cannot be
/// read or its hash differs from `sha256` (unless that is empty).
std::optional<std::string> ReadAsset(const std::filesystem::path& file, const std::string& sha256,
                                     diag::Findings& findings);

/// A folder of objects and their assets. Several processes may write different files to one folder
/// at the same time.
class ObjectFolder {
 public:
  ObjectFolder(std::filesystem::path folder, const OverwritePolicy& overwrite)
      : folder_(std::move(folder)), overwrite_(overwrite) {}

  /// Writes an object's file, whose name may contain folders, after the assets beside it. Each
  /// asset is written once. Files that mjforge did not make are replaced only if the overwrite
  /// policy allows it. `hashes` are manifest::Record::assets; if the hash of an asset differs from
  /// them, adds a finding, because the asset was changed while the batch was made.
  bool Write(const std::string& file, const mjcf::MjcfDocument& document, diag::Findings& findings,
             const AssetHashes& hashes = {});

 private:
  bool CopyAssets(const mjcf::MjcfDocument& document, const std::filesystem::path& folder,
                  const AssetHashes& hashes, diag::Findings& findings);
  bool IsOwn(const bytes::Asset& asset, std::string_view present, std::string_view bytes,
             const std::string& sha256) const;
  bool CopyAsset(const bytes::Asset& asset, const std::filesystem::path& target,
                 const std::string& sha256, diag::Findings& findings) const;

  std::filesystem::path folder_;
  OverwritePolicy overwrite_;
  MadeFolders folders_;
  std::filesystem::path last_folder_;       // folder of the last file
  std::set<std::filesystem::path> assets_;  // assets that were written already
};

/// Removes the temporary files that killed processes left when writing `files`. Keeps temporary
/// files that a running process has locked.
void RemoveAbandoned(const std::set<std::filesystem::path>& files);
/// Removes the abandoned temporary files of `count` objects from index `first` on, and of the
/// assets beside them, from a folder of objects and its numbered subfolders (million objects,
/// structures).
void RemoveAbandoned(const std::filesystem::path& folder, std::uint64_t first, std::uint64_t count);

/// Writes a file that is not part of a batch, after removing its abandoned temporary files.
bool WriteSingleFile(const std::filesystem::path& file, std::string_view bytes,
                     diag::Findings& findings);

/// Returns the index in an object's file name: 42 for "hammer_000042.xml"; nullopt for other names.
std::optional<std::uint64_t> IndexOfFile(std::string_view file);

/// Returns the rule "TARGETS: FILES" for Make in the format of compilers' -MF: one file per line,
/// with names escaped. Targets are written unchanged. With `phony`, each file is also a
/// target without a rule, so that Make continues if a file is deleted.
std::string MakeRule(std::span<const std::string> targets, const std::set<std::string>& files,
                     bool phony);
/// Escapes a name for use in a Make rule, as a target or as a file.
std::string EscapeForMake(std::string_view name, bool is_target);
/// Returns false for names that Make cannot read in a rule, in any form: those with `;`, `=`, `|`,
/// a line end, or a backslash before `#`.
bool FitsMake(std::string_view name);

/// Returns a text as one word of a shell's command line, quoted if necessary.
std::string ShellWord(std::string_view word);

}  // namespace mjforge::output
