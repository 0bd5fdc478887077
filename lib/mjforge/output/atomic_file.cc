// Atomic writing of small files: temporary name, synchronization, renaming.

#include "mjforge/output/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "mjforge/bytes/bytes.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// Limit of names to try, because a killed process with the same id may have left a file behind.
constexpr int kTriedNames = 100;

// Opens a new temporary file beside `file`; returns -1, with errno, if that fails.
int OpenTemporary(const std::filesystem::path& file, std::string& temporary) {
  int descriptor = -1;
  for (int attempt = 0; descriptor < 0 && attempt < kTriedNames; ++attempt) {
    const std::string name =
        fmt::format(".{}.tmp{}-{}", file.filename().string(), ::getpid(), attempt);
    temporary = (file.parent_path() / name).string();
    descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  // RemoveAbandoned leaves locked files alone.
  if (descriptor >= 0) ::flock(descriptor, LOCK_EX | LOCK_NB);
  return descriptor;
}

}  // namespace

std::optional<std::string> FinalNameOf(std::string_view temporary) {
  const std::size_t tail = temporary.rfind(".tmp");
  if (!temporary.starts_with('.') || tail == temporary.npos || tail < 2) return std::nullopt;
  const std::string_view numbers = temporary.substr(tail + 4);
  const std::size_t dash = numbers.find('-');
  if (dash == numbers.npos || dash == 0 || dash + 1 == numbers.size() ||
      numbers.find_first_not_of("0123456789-") != numbers.npos ||
      numbers.find('-', dash + 1) != numbers.npos) {
    return std::nullopt;
  }
  return std::string(temporary.substr(1, tail - 1));
}

void AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings) {
  findings.Add(
      diag::Code::kOutputCannotWrite, {},
      fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(error)));
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

bool WriteFile(const std::filesystem::path& file, std::string_view bytes, bool if_changed,
               diag::Findings& findings, Durability durability) {
  std::string ignored;
  if (if_changed && bytes::Read(file, bytes.size(), ignored) == bytes) return true;
  std::string temporary;
  const int descriptor = OpenTemporary(file, temporary);
  if (descriptor < 0) {
    AddCannotWrite(file, errno, findings);
    return false;
  }
  const bool is_written = WriteAll(descriptor, bytes, file, findings);
  const bool is_synced =
      is_written && (durability == Durability::kNone || ::fdatasync(descriptor) == 0);
  // On a network disk or at a quota, only close() reports that writing failed.
  if (::close(descriptor) == 0 && is_synced && std::rename(temporary.c_str(), file.c_str()) == 0) {
    return durability == Durability::kNone || SyncFolder(file.parent_path(), false, findings);
  }
  if (is_written) AddCannotWrite(file, errno, findings);
  ::unlink(temporary.c_str());
  return false;
}

}  // namespace mjforge::output
