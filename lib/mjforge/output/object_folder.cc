#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "mjforge/bytes/bytes.h"
#include "mjforge/output/atomic_file.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// Keeps a copy that is there with the same bytes.
bool CopyAsset(const std::filesystem::path& source, const std::filesystem::path& target,
               bool replace, diag::Findings& findings) {
  const std::optional<std::string> bytes = ReadFile(source, bytes::kMaxAsset, findings);
  if (!bytes) return false;
  if (std::error_code ignored; std::filesystem::exists(target, ignored)) {
    const std::optional<std::string> present = ReadFile(target, bytes::kMaxAsset, findings);
    if (!present) return false;
    if (*present == *bytes) return true;
    if (!replace) {
      findings.Add(diag::Code::kOutputExists, {},
                   fmt::format("'{}' exists, and its content differs from '{}'", target.string(),
                               source.string()),
                   "choose another place, or overwrite it with --force");
      return false;
    }
  }
  return WriteFile(target, *bytes, false, findings);
}

// "hammer_000042.xml" -> 42.
std::optional<std::uint64_t> IndexOf(std::string_view file) {
  const std::size_t start = file.rfind('_');
  if (start == file.npos || !file.ends_with(".xml")) return std::nullopt;
  return ReadIndex(file.substr(start + 1, file.size() - start - 5));
}

}  // namespace

void RemoveHalfWritten(const std::filesystem::path& folder,
                       const std::function<bool(std::uint64_t)>& is_ours, bool assets) {
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::optional<std::string> file = UnderConstruction(at->path().filename().string());
    if (!file) continue;
    const std::optional<std::uint64_t> index = IndexOf(*file);
    if (index ? is_ours(*index) : assets) found.push_back(at->path());
  }
  for (const std::filesystem::path& file : found) std::filesystem::remove(file, error);
}

MadeFolders::~MadeFolders() {
  // rmdir refuses a folder that holds anything.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
}

bool MadeFolders::Make(const std::filesystem::path& folder, diag::Findings& findings) {
  std::filesystem::path path;
  for (const std::filesystem::path& name : folder) {
    path /= name;
    struct stat status;
    if (::stat(path.c_str(), &status) == 0) {
      if (S_ISDIR(status.st_mode)) continue;
      errno = ENOTDIR;
    } else if (::mkdir(path.c_str(), 0777) == 0) {
      made_.push_back(path);
      continue;
    } else if (errno == EEXIST && ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
      continue;  // another process was quicker
    }
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("cannot make folder '{}': {}", path.string(),
                             std::generic_category().message(errno)));
    return false;
  }
  return true;
}

bool ObjectFolder::CopyAssets(const mjcf::MjcfDocument& document,
                              const std::filesystem::path& folder, diag::Findings& findings) {
  for (const auto& [name, source] : document.assets) {
    const std::filesystem::path target = folder / name;
    if (assets_.contains(target)) continue;
    if (!folders_.Make(target.parent_path(), findings)) return false;
    if (!CopyAsset(source, target, overwrite_.force || overwrite_.assets, findings)) return false;
    assets_.insert(target);
  }
  return true;
}

bool ObjectFolder::Write(const std::string& file, const mjcf::MjcfDocument& document,
                         diag::Findings& findings) {
  const std::filesystem::path path = folder_ / file;
  const std::filesystem::path folder = path.parent_path();
  if (folder != known_folder_) {
    if (!folders_.Make(folder, findings)) return false;
    known_folder_ = folder;
  }
  // Assets first: an object never stands there without what it refers to.
  return MayReplace(path, overwrite_.force, findings) && CopyAssets(document, folder, findings) &&
         WriteFile(path, document.text, overwrite_.if_changed, findings);
}

}  // namespace mjforge::output
