// Synchronization of folders with the disk.

#include "mjforge/output/durability.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "mjforge/output/atomic_file.h"

namespace mjforge::output {

bool SyncFolder(const std::filesystem::path& folder, bool contents, diag::Findings& findings) {
  const std::filesystem::path name = folder.empty() ? "." : folder;
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // Ignores EINVAL, the error of a file system that cannot synchronize folders.
  const bool synced =
      descriptor >= 0 &&
      ((contents ? ::syncfs(descriptor) : ::fsync(descriptor)) == 0 || errno == EINVAL);
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) AddCannotWrite(name, error, findings);
  return synced;
}

}  // namespace mjforge::output
