#include "mjforge/output/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace mjforge::output {
namespace {

// Names of one process never meet; a leftover of a killed one with the same
// number might be in the way, so a few names are tried.
constexpr int kTriedNames = 100;

std::string TemporaryName(const std::filesystem::path& file, int attempt) {
  const std::string name =
      fmt::format(".{}.tmp{}-{}", file.filename().string(), ::getpid(), attempt);
  return (file.parent_path() / name).string();
}

}  // namespace

std::optional<std::string> UnderConstruction(std::string_view hidden) {
  const std::size_t tail = hidden.rfind(".tmp");
  if (!hidden.starts_with('.') || tail == hidden.npos || tail < 2) return std::nullopt;
  const std::string_view numbers = hidden.substr(tail + 4);
  const std::size_t dash = numbers.find('-');
  if (dash == numbers.npos || dash == 0 || dash + 1 == numbers.size() ||
      numbers.find_first_not_of("0123456789-") != numbers.npos ||
      numbers.find('-', dash + 1) != numbers.npos) {
    return std::nullopt;
  }
  return std::string(hidden.substr(1, tail - 1));
}

void AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings) {
  findings.Add(
      diag::Code::kOutputCannotWrite, {},
      fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(error)));
}

AtomicFile::AtomicFile(std::filesystem::path file, std::string temporary, int descriptor)
    : file_(std::move(file)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile::~AtomicFile() { Drop(); }

void AtomicFile::Drop() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

std::unique_ptr<AtomicFile> AtomicFile::Create(const std::filesystem::path& file,
                                               diag::Findings& findings) {
  for (int attempt = 0; attempt < kTriedNames; ++attempt) {
    std::string temporary = TemporaryName(file, attempt);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) ::flock(descriptor, LOCK_EX | LOCK_NB);  // RemoveHalfWritten asks for it
    if (descriptor >= 0)
      return std::unique_ptr<AtomicFile>(new AtomicFile(file, std::move(temporary), descriptor));
    if (errno != EEXIST) break;
  }
  AddCannotWrite(file, errno, findings);
  return nullptr;
}

bool WriteAll(int descriptor, std::string_view bytes, const std::filesystem::path& file,
              diag::Findings& findings) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      AddCannotWrite(file, errno, findings);
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool AtomicFile::Append(std::string_view bytes, diag::Findings& findings) {
  const bool written = WriteAll(descriptor_, bytes, file_, findings);
  if (!written) Drop();
  return written;
}

bool AtomicFile::Commit(Durability durability, diag::Findings& findings) {
  // On a network disk or at a quota, only close() says that writing failed.
  if ((durability == Durability::kBatch && ::fdatasync(descriptor_) != 0) ||
      ::close(std::exchange(descriptor_, -1)) != 0 ||
      std::rename(temporary_.c_str(), file_.c_str()) != 0) {
    AddCannotWrite(file_, errno, findings);
    Drop();
    return false;
  }
  temporary_.clear();
  return durability == Durability::kNone || SyncFolder(file_.parent_path(), false, findings);
}

}  // namespace mjforge::output
