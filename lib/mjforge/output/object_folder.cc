// Folders of objects and their assets, and removal of abandoned temporary files.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>

#include "mjforge/bytes/bytes.h"
#include "mjforge/output/atomic_file.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// Limit of the assets remembered as written, because each variant may have generated assets of its
// own.
constexpr std::size_t kMaxRememberedAssets = 10'000;

// Removes a temporary file unless a running process has locked it. Holds the lock during the
// removal, so that a process that has just made the file notices the removal.
void RemoveIfAbandoned(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return;
  struct stat status;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &status) == 0 &&
      status.st_nlink > 0) {
    ::unlink(file.c_str());
  }
  ::close(descriptor);
}

// Returns true for a folder, and false for a symbolic link to a folder.
bool IsOwnFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(std::filesystem::symlink_status(path, ignored));
}

// Returns true for the name of a folder that contains the variants of one structure.
bool IsStructureFolder(std::string_view name) {
  constexpr std::size_t kDigits = 12;
  return name.size() == kDigits && name.find_first_not_of("0123456789abcdef") == name.npos;
}

// Removes the temporary files that killed processes left in a folder. `is_ours` decides by the
// final name of each temporary file.
void RemoveAbandonedIn(const std::filesystem::path& folder,
                       const std::function<bool(const std::string&)>& is_ours) {
  std::error_code ignored;
  for (const std::filesystem::path& entry : EntriesOf(folder, ignored)) {
    const std::optional<std::string> file = FinalNameOf(entry.filename().string());
    if (file && is_ours(*file)) RemoveIfAbandoned(entry);
  }
}

}  // namespace

std::vector<std::filesystem::path> EntriesOf(const std::filesystem::path& folder,
                                             std::error_code& error) {
  std::vector<std::filesystem::path> entries;
  std::filesystem::directory_iterator at(folder.empty() ? "." : folder, error);
  for (; !error && at != std::filesystem::directory_iterator(); at.increment(error))
    entries.push_back(at->path());
  return entries;
}

std::optional<std::uint64_t> IndexOfFile(std::string_view file) {
  const std::size_t start = file.rfind('_');
  if (start == file.npos || !file.ends_with(".xml")) return std::nullopt;
  return ReadIndex(file.substr(start + 1, file.size() - start - 5));
}

namespace {

// Removes all abandoned temporary files in the folders of variants (--each). `is_object` selects
// these folders: its argument is the folder's name with the ending of an object's file.
void RemoveAbandonedParts(const std::filesystem::path& folder,
                          const std::function<bool(const std::string&)>& is_object) {
  const auto is_any = [](const std::string&) { return true; };
  std::error_code ignored;
  for (const std::filesystem::path& entry : EntriesOf(folder, ignored)) {
    if (!is_object(entry.filename().string() + std::string(kObjectEnding)) || !IsOwnFolder(entry))
      continue;
    std::vector<std::filesystem::path> below = {entry};
    for (std::filesystem::recursive_directory_iterator inner(entry, ignored);
         !ignored && inner != std::filesystem::recursive_directory_iterator();
         inner.increment(ignored)) {
      if (IsOwnFolder(inner->path())) below.push_back(inner->path());
    }
    for (const std::filesystem::path& one : below) RemoveAbandonedIn(one, is_any);
  }
}

}  // namespace

void RemoveAbandoned(const std::set<std::filesystem::path>& files) {
  std::set<std::filesystem::path> folders;
  for (const std::filesystem::path& file : files) folders.insert(file.parent_path());
  for (const std::filesystem::path& folder : folders) {
    RemoveAbandonedIn(folder,
                      [&](const std::string& file) { return files.contains(folder / file); });
  }
}

void RemoveAbandoned(const std::filesystem::path& folder, std::uint64_t first,
                     std::uint64_t count) {
  const auto is_object = [&](const std::string& file) {
    const std::optional<std::uint64_t> index = IndexOfFile(file);
    return index && *index >= first && *index - first < count;
  };
  std::vector<std::filesystem::path> folders = {folder};
  std::error_code ignored;
  for (const std::filesystem::path& entry : EntriesOf(folder, ignored)) {
    const std::string name = entry.filename().string();
    const auto start = ReadIndex(name);
    const bool has_objects =
        start && (*start < first ? first - *start < kFilesPerFolder : *start - first < count);
    if (has_objects && IsOwnFolder(entry)) folders.push_back(entry);
    if (IsStructureFolder(name) && IsOwnFolder(entry)) RemoveAbandoned(entry, first, count);
  }
  for (const std::filesystem::path& objects : folders) {
    RemoveAbandonedIn(objects, is_object);
    RemoveAbandonedParts(objects, is_object);
    const std::filesystem::path assets = (objects / mjcf::kAssetFolder).parent_path();
    if (IsOwnFolder(assets)) RemoveAbandonedIn(assets, [](const std::string&) { return true; });
  }
}

MadeFolders::~MadeFolders() {
  // Keeps folders that are not empty, because rmdir fails for them.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
}

bool MadeFolders::MakeOne(const std::filesystem::path& path, bool follow,
                          diag::Findings& findings) {
  struct stat status;
  const auto exists = [&] {
    return (follow ? ::stat(path.c_str(), &status) : ::lstat(path.c_str(), &status)) == 0;
  };
  bool found = exists();
  int error = ENOTDIR;
  if (!found) {
    if (::mkdir(path.c_str(), 0777) == 0) {
      made_.push_back(path);
      return true;
    }
    error = errno;
    found = error == EEXIST && exists();  // another process may have made the folder meanwhile
  }
  if (found && S_ISDIR(status.st_mode)) return true;
  findings.Add(diag::Code::kOutputCannotWrite, {},
               found && S_ISLNK(status.st_mode)
                   ? fmt::format("'{}' is a link, which is not followed", path.string())
                   : fmt::format("cannot make folder '{}': {}", path.string(),
                                 std::generic_category().message(error)));
  return false;
}

bool MadeFolders::MakeAll(std::filesystem::path path, const std::filesystem::path& folder,
                          bool follow, diag::Findings& findings) {
  return std::all_of(folder.begin(), folder.end(), [&](const std::filesystem::path& name) {
    path /= name;
    return MakeOne(path, follow, findings);
  });
}

bool MadeFolders::Make(const std::filesystem::path& folder, diag::Findings& findings) {
  return MakeAll({}, folder, true, findings);
}

bool MadeFolders::MakeBelow(const std::filesystem::path& base, const std::filesystem::path& folder,
                            diag::Findings& findings) {
  return MakeAll(base, folder, false, findings);
}

std::optional<std::string> ReadAsset(const std::filesystem::path& file, const std::string& sha256,
                                     diag::Findings& findings) {
  std::optional<std::string> bytes = ReadFile(file, bytes::kMaxAsset, findings);
  if (!bytes || sha256.empty() || bytes::Sha256Of(*bytes) == sha256) return bytes;
  AddAssetChanged(file.string(), findings);
  return std::nullopt;
}

void AddAssetChanged(const std::string& name, diag::Findings& findings) {
  findings.Add(diag::Code::kBatchChanged, {},
               fmt::format("'{}' was changed while the batch was made", name),
               "make the batch anew, without --resume");
}

namespace {

// Returns true for the file of an object of a scene (--each), which is an asset of the placement.
bool IsObject(const bytes::Asset& asset) {
  return asset.made && asset.name.ends_with(kObjectEnding);
}

// Returns the files in the folder of a variant that can be files of its objects: NAME.xml and, for
// targets with a folder for each object, NAME/model.xml. Links are not followed.
std::vector<std::filesystem::path> ObjectFilesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const std::filesystem::path& entry : EntriesOf(folder, ignored)) {
    if (IsOwnFolder(entry))
      std::ranges::copy(EntriesOf(entry, ignored), std::back_inserter(files));
    else
      files.push_back(entry);
  }
  std::erase_if(files, [&](const std::filesystem::path& file) {
    return file.extension() != kObjectEnding ||
           !std::filesystem::is_regular_file(std::filesystem::symlink_status(file, ignored));
  });
  return files;
}

// Removes the files of objects that an earlier run wrote for this variant and that the variant no
// longer has, because a scene would otherwise have more objects than its placement. `assets` are
// the files of the placement in `folder`.
void RemoveFormerObjects(const std::filesystem::path& folder, const bytes::Assets& assets) {
  const auto object = std::ranges::find_if(assets, IsObject);
  if (object == assets.end()) return;
  const std::optional<mjcf::Provenance> own = mjcf::ReadProvenance(*object->made);
  if (!own) return;
  std::string ignored;
  for (const std::filesystem::path& file : ObjectFilesIn(folder)) {
    const std::string name = file.lexically_relative(folder).generic_string();
    if (std::ranges::count(assets, name, &bytes::Asset::name) > 0) continue;
    const auto opening = bytes::ReadStart(file, kCommentBytes, ignored);
    const auto former = opening ? mjcf::ReadProvenance(*opening) : std::nullopt;
    if (!former || former->part.empty() || former->index != own->index) continue;
    ::unlink(file.c_str());
    if (file.parent_path() != folder) ::rmdir(file.parent_path().c_str());  // unless it has files
  }
}

}  // namespace

// Returns true if an existing file with the content `present` may be replaced by `asset`, which has
// the content `bytes` and the hash `sha256`.
bool ObjectFolder::IsOwn(const bytes::Asset& asset, std::string_view present,
                         std::string_view bytes, const std::string& sha256) const {
  // Only a damaged copy may be replaced by a generated asset, whose name has a hash of its content.
  if (asset.made) return IsDamagedCopy(present, bytes);
  const auto kept = overwrite_.kept_assets.find(asset.name);
  if (kept != overwrite_.kept_assets.end()) return kept->second == sha256;
  return overwrite_.assets.contains(sha256) || overwrite_.assets.contains(bytes::Sha256Of(present));
}

// Writes an asset to `target`, unless that file already has the same bytes. Returns false, after
// adding a finding, if the file may not be replaced or cannot be written.
bool ObjectFolder::CopyAsset(const bytes::Asset& asset, const std::filesystem::path& target,
                             const std::string& sha256, diag::Findings& findings) const {
  if (IsObject(asset)) {
    return MayReplace(target, *asset.made, overwrite_.force, findings) &&
           WriteFile(target, *asset.made, true, findings);
  }
  std::optional<std::string> read;
  if (!asset.made) read = ReadAsset(asset.file, sha256, findings);
  if (!asset.made && !read) return false;
  const std::string& bytes = asset.made ? *asset.made : *read;
  if (bytes::Exists(target)) {
    const std::optional<std::string> present = ReadFile(target, bytes::kMaxAsset, findings);
    if (!present) return false;
    if (*present == bytes) return true;
    if (!overwrite_.force && !IsOwn(asset, *present, bytes, sha256)) {
      findings.Add(
          diag::Code::kOutputExists, {},
          fmt::format("'{}' exists, and its content differs from {}", target.string(),
                      asset.made ? "what belongs there" : fmt::format("'{}'", asset.file.string())),
          "choose another place, or overwrite it with --force");
      return false;
    }
  }
  // Generated assets are not synchronized one by one: like objects, they can be made again after a
  // power cut, and the batch waits for all of them together.
  return WriteFile(target, bytes, false, findings,
                   asset.made ? Durability::kNone : overwrite_.durability);
}

bool ObjectFolder::CopyAssets(const mjcf::MjcfDocument& document,
                              const std::filesystem::path& folder, const AssetHashes& hashes,
                              diag::Findings& findings) {
  for (const bytes::Asset& asset : document.assets) {
    const std::filesystem::path target = folder / asset.name;
    if (assets_.contains(target)) continue;
    const std::filesystem::path below = std::filesystem::path(asset.name).parent_path();
    if (!folders_.MakeBelow(folder, below, findings)) return false;
    const auto hash = std::ranges::find(hashes, asset.name, &AssetHashes::value_type::first);
    if (!CopyAsset(asset, target, hash == hashes.end() ? std::string() : hash->second, findings))
      return false;
    if (assets_.size() >= kMaxRememberedAssets) assets_.clear();
    assets_.insert(target);
  }
  return true;
}

bool ObjectFolder::Write(const std::string& file, const mjcf::MjcfDocument& document,
                         diag::Findings& findings, const AssetHashes& hashes) {
  const std::filesystem::path path = folder_ / file;
  const std::filesystem::path folder = path.parent_path();
  if (folder != last_folder_) {
    const std::filesystem::path below = std::filesystem::path(file).parent_path();
    if (!folders_.Make(folder_, findings) || !folders_.MakeBelow(folder_, below, findings))
      return false;
    last_folder_ = folder;
  }
  // Writes assets first, so that an object's file never exists without its assets.
  if (!MayReplace(path, document.text, overwrite_.force, findings) ||
      !CopyAssets(document, folder, hashes, findings))
    return false;
  RemoveFormerObjects(folder, document.assets);
  return WriteFile(path, document.text, overwrite_.if_changed, findings);
}

}  // namespace mjforge::output
