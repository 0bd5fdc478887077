// Atomic writing of small files: temporary name, synchronization, renaming.

#include "mjforge/output/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "mjforge/bytes/bytes.h"
#include "mjforge/output/destination.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

// Limit of temporary names to try. A name may be in use because a killed process with the same id
// left a file behind, or because a process that removes such files has locked a new file.
constexpr int kTriedNames = 100;

// Locks an open file without waiting. Returns false if another process has the lock or has removed
// the file; returns true if the file system has no locks.
bool LockNew(int descriptor) {
  struct stat status;
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

// Opens and locks a new temporary file beside `file`; returns -1, with errno, if that fails.
int OpenTemporary(const std::filesystem::path& file, std::string& temporary) {
  for (int attempt = 0; attempt < kTriedNames; ++attempt) {
    const std::string name =
        fmt::format(".{}.tmp{}-{}", file.filename().string(), ::getpid(), attempt);
    temporary = (file.parent_path() / name).string();
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 && LockNew(descriptor)) return descriptor;
    if (descriptor < 0 && errno != EEXIST) return -1;
    if (descriptor >= 0) ::close(descriptor);
  }
  errno = EEXIST;
  return -1;
}

// Closes a duplicate of an open file, because on a network disk or at a quota only close() reports
// that writing failed; the file itself remains open and locked. Returns false, with errno, if
// close() fails.
bool Flush(int descriptor) {
  const int duplicate = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  return duplicate >= 0 && ::close(duplicate) == 0;
}

}  // namespace

std::optional<std::string> FinalNameOf(std::string_view temporary) {
  const std::size_t tail = temporary.rfind(".tmp");
  if (!temporary.starts_with('.') || tail == temporary.npos || tail < 2) return std::nullopt;
  const std::string_view numbers = temporary.substr(tail + 4);
  const std::size_t dash = numbers.find('-');
  if (dash == numbers.npos || !ReadIndex(numbers.substr(0, dash)) ||
      !ReadIndex(numbers.substr(dash + 1))) {
    return std::nullopt;
  }
  return std::string(temporary.substr(1, tail - 1));
}

bool AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings) {
  findings.Add(
      diag::Code::kOutputCannotWrite, {},
      fmt::format("cannot write '{}': {}", file.string(), std::generic_category().message(error)));
  return false;
}

bool WriteSingleFile(const std::filesystem::path& file, std::string_view bytes,
                     diag::Findings& findings) {
  RemoveAbandoned({file});
  return WriteFile(file, bytes, false, findings);
}

bool WriteFile(const std::filesystem::path& file, std::string_view bytes, bool if_changed,
               diag::Findings& findings, Durability durability) {
  std::string ignored;
  if (if_changed && bytes::Read(file, bytes.size(), ignored) == bytes) return true;
  std::string temporary;
  const int descriptor = OpenTemporary(file, temporary);
  if (descriptor < 0) return AddCannotWrite(file, errno, findings);
  const bool is_synced = bytes::WriteAll(descriptor, bytes) &&
                         (durability == Durability::kNone || ::fdatasync(descriptor) == 0);
  // Holds the lock until the file has its final name, because RemoveAbandoned() removes temporary
  // files that no process has locked.
  const bool is_renamed =
      is_synced && Flush(descriptor) && std::rename(temporary.c_str(), file.c_str()) == 0;
  if (!is_renamed) {
    AddCannotWrite(file, errno, findings);
    ::unlink(temporary.c_str());
  }
  ::close(descriptor);
  return is_renamed &&
         (durability == Durability::kNone || SyncFolder(file.parent_path(), false, findings));
}

}  // namespace mjforge::output
