#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>

#include "mjforge/output/atomic_file.h"
#include "mjforge/output/folders.h"
#include "mjforge/output/output.h"
#include "mjforge/output/reading.h"

namespace mjforge::output {
namespace {

constexpr const char* kManifestName = "manifest.jsonl";
// Lines are collected up to this size before they are written.
constexpr std::size_t kManifestBuffer = 64 * 1024;
// Enough for the first line of any manifest, which may be gigabytes long.
constexpr std::size_t kLongestLine = 1024 * 1024;

// A manifest is ours if its first line is a record. An empty one holds nothing
// that could be lost.
bool IsOurManifest(std::string_view text) {
  std::string why_not;
  return text.empty() || ReadRecord(text.substr(0, text.find('\n')), why_not).has_value();
}

struct Destination {
  std::filesystem::path folder;
  bool force = false;
};

bool CopyAsset(const std::filesystem::path& source, const std::filesystem::path& target, bool force,
               diag::Findings& findings) {
  const std::optional<std::string> bytes = ReadFile(source, findings);
  if (!bytes) return false;
  if (std::error_code ignored; std::filesystem::exists(target, ignored)) {
    const std::optional<std::string> present = ReadFile(target, findings);
    if (!present) return false;
    if (*present == *bytes) return true;
    if (!force) {
      findings.Add(
          diag::Code::kOutputExists, {},
          fmt::format("'{}' exists with other content than '{}'", target.string(), source.string()),
          "choose another place, or overwrite it with --force");
      return false;
    }
  }
  return WriteFile(target, *bytes, findings);
}

// Copies the assets that are not in `done` yet.
bool CopyNewAssets(const mjcf::MjcfDocument& document, const Destination& destination,
                   MadeFolders& folders, std::set<std::string>& done, diag::Findings& findings) {
  for (const auto& [name, source] : document.assets) {
    if (done.contains(name)) continue;
    const std::filesystem::path target = destination.folder / name;
    if (!folders.Make(target.parent_path(), findings)) return false;
    if (!CopyAsset(source, target, destination.force, findings)) return false;
    done.insert(name);
  }
  return true;
}

}  // namespace

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

struct DirectoryWriter::State {
  MadeFolders folders;  // first: goes last, when the manifest's hidden file is gone
  Destination destination;
  bool replaces_assets = false;
  std::set<std::string> assets;
  std::optional<AtomicFile> manifest;
  std::string lines;  // of the manifest, not written yet
};

DirectoryWriter::DirectoryWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
DirectoryWriter::DirectoryWriter(DirectoryWriter&&) noexcept = default;
DirectoryWriter& DirectoryWriter::operator=(DirectoryWriter&&) noexcept = default;
DirectoryWriter::~DirectoryWriter() = default;

std::optional<DirectoryWriter> DirectoryWriter::Open(const std::filesystem::path& folder,
                                                     bool force, diag::Findings& findings) {
  auto state = std::make_unique<State>();
  state->destination = {folder, force};
  if (!state->folders.Make(folder, findings)) return std::nullopt;
  const std::filesystem::path manifest = folder / kManifestName;
  std::error_code ignored;
  if (std::filesystem::exists(manifest, ignored)) {
    const std::optional<std::string> start = ReadStart(manifest, kLongestLine);
    const bool ours = start && IsOurManifest(*start);
    if (!ours && !force) {
      findings.Add(diag::Code::kOutputExists, {},
                   fmt::format("'{}' exists and was not made by mjforge", manifest.string()),
                   "choose another folder, or overwrite it with --force");
      return std::nullopt;
    }
    state->replaces_assets = ours;
  }
  state->manifest = AtomicFile::Create(manifest, findings);
  if (!state->manifest) return std::nullopt;
  return DirectoryWriter(std::move(state));
}

bool DirectoryWriter::Write(const std::string& file, const mjcf::MjcfDocument& document,
                            diag::Findings& findings) {
  const std::filesystem::path path = state_->destination.folder / file;
  if (!MayReplace(path, state_->destination.force, findings)) return false;
  const Destination assets = {state_->destination.folder,
                              state_->destination.force || state_->replaces_assets};
  // Assets first: an object never stands there without what it refers to.
  return CopyNewAssets(document, assets, state_->folders, state_->assets, findings) &&
         WriteFile(path, document.text, findings);
}

bool DirectoryWriter::Add(const Record& record, diag::Findings& findings) {
  AppendRecord(state_->lines, record);
  if (state_->lines.size() < kManifestBuffer) return true;
  const bool written = state_->manifest->Append(state_->lines, findings);
  state_->lines.clear();
  return written;
}

bool DirectoryWriter::Finish(diag::Findings& findings) {
  return state_->manifest->Append(state_->lines, findings) && state_->manifest->Commit(findings);
}

bool CopyAssets(const mjcf::MjcfDocument& document, const std::filesystem::path& folder, bool force,
                diag::Findings& findings) {
  MadeFolders folders;
  std::set<std::string> done;
  return CopyNewAssets(document, {folder, force}, folders, done, findings);
}

bool WriteObject(const std::filesystem::path& file, const mjcf::MjcfDocument& document, bool force,
                 diag::Findings& findings) {
  MadeFolders folders;
  const std::filesystem::path folder = file.parent_path();
  if (!folder.empty() && !folders.Make(folder, findings)) return false;
  return MayReplace(file, force, findings) && CopyAssets(document, folder, force, findings) &&
         WriteFile(file, document.text, findings);
}

}  // namespace mjforge::output
