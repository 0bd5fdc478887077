// A long file under construction: locking, reserved blocks, early writeback, renaming.

#include "mjforge/output/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <span>
#include <thread>
#include <utility>

#include "mjforge/output/atomic_file.h"

namespace mjforge::output {
namespace {

// Size of the blocks of early writeback: the system writes a block to the disk while the next bytes
// are made, so that the final synchronization has little left to do.
constexpr std::uint64_t kWritebackBytes = std::uint64_t{8} << 20;

// Disk space reserved in advance, which saves a third of the system's work for each write. No space
// is reserved if less than kEnoughRoom is free, because the manifest beside an archive needs space,
// too.
constexpr std::uint64_t kReserve = std::uint64_t{8} << 20;
constexpr std::uint64_t kEnoughRoom = std::uint64_t{1} << 30;

constexpr std::uint64_t kCopyBytes = std::uint64_t{1} << 20;

// Number of attempts to lock a part, because a killed process and its workers may need some time to
// release the lock.
constexpr int kLockTries = 20;
constexpr auto kLockPause = std::chrono::milliseconds(50);

bool IsSameFile(int descriptor, const std::filesystem::path& path) {
  struct stat opened;
  struct stat named;
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

}  // namespace

PartFile::PartFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor,
                   std::uint64_t size)
    : file_(std::move(file)),
      temporary_(std::move(temporary)),
      descriptor_(descriptor),
      size_(size) {}

PartFile::~PartFile() {
  if (descriptor_ < 0) return;
  ReleaseReserve();
  ::close(descriptor_);
}

std::filesystem::path PartFile::TemporaryNameOf(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.part", file.filename().string());
}

bool PartFile::Exists(const std::filesystem::path& file) {
  return bytes::Exists(TemporaryNameOf(file));
}

std::unique_ptr<PartFile> PartFile::Open(const std::filesystem::path& file,
                                         diag::Findings& findings) {
  const std::filesystem::path temporary = TemporaryNameOf(file);
  for (int tries = 1;;) {
    const int descriptor =
        ::open(temporary.c_str(),
               O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (descriptor < 0) {
      AddCannotWrite(errno == ELOOP ? temporary : file, errno, findings);
      return nullptr;
    }
    struct stat status;
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
      ::close(descriptor);
      findings.Add(diag::Code::kOutputCannotWrite, {},
                   fmt::format("cannot write '{}': it is not a file", temporary.string()));
      return nullptr;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);
      if (++tries <= kLockTries) {
        std::this_thread::sleep_for(kLockPause);
        continue;
      }
      findings.Add(diag::Code::kOutputCannotWrite, {},
                   fmt::format("cannot write '{}': another mjforge is writing it", file.string()),
                   "wait for it, or choose another place");
      return nullptr;
    }
    // The process that had the lock may have renamed the part before releasing the lock.
    if (!IsSameFile(descriptor, temporary)) {
      ::close(descriptor);
      continue;
    }
    return std::unique_ptr<PartFile>(
        new PartFile(file, temporary, descriptor, static_cast<std::uint64_t>(status.st_size)));
  }
}

// Reserves disk space up to `end`. Ignores errors, because not every file system can reserve space.
void PartFile::Reserve(std::uint64_t end) {
  if (end < kReserve || end <= reserved_) return;
  reserved_ = end + kReserve;
  std::error_code error;
  const std::filesystem::space_info disk = std::filesystem::space(temporary_, error);
  if (error || disk.available < kEnoughRoom) return;
  ::fallocate(descriptor_, FALLOC_FL_KEEP_SIZE, static_cast<::off_t>(size_),
              static_cast<::off_t>(reserved_ - size_));
}

bool PartFile::ReleaseReserve() {
  return reserved_ == 0 || ::ftruncate(descriptor_, static_cast<::off_t>(size_)) == 0;
}

bool PartFile::Append(std::string_view bytes, diag::Findings& findings) {
  Reserve(size_ + bytes.size());
  if (!bytes::WriteAll(descriptor_, bytes)) return AddCannotWrite(file_, errno, findings);
  size_ += bytes.size();
  checksum_.Add(bytes);
  if (size_ - writeback_end_ >= kWritebackBytes) {
    // Ignores errors, because this call is only a hint.
    ::sync_file_range(descriptor_, static_cast<::off64_t>(writeback_end_),
                      static_cast<::off64_t>(size_ - writeback_end_), SYNC_FILE_RANGE_WRITE);
    writeback_end_ = size_;
  }
  return true;
}

bool PartFile::AppendFrom(const std::filesystem::path& file, std::uint64_t count,
                          diag::Findings& findings) {
  std::string why_not;
  std::optional<bytes::File> from = bytes::File::Open(file, why_not);
  std::string buffer(std::min(count, kCopyBytes), '\0');
  while (from && count > 0) {
    const std::optional<std::size_t> got =
        from->Read(std::span(buffer).first(std::min<std::uint64_t>(count, buffer.size())), why_not);
    if (got.value_or(0) == 0) break;
    if (!Append(std::string_view(buffer).substr(0, *got), findings)) return false;
    count -= *got;
  }
  if (count == 0) return true;
  findings.AddCannotRead(file.string(), why_not.empty() ? "it is shorter than before" : why_not);
  return false;
}

bool PartFile::AppendSeekTable(diag::Findings& findings) {
  std::string why_not;
  const std::optional<std::vector<bytes::Frame>> frames = bytes::FramesOf(temporary_, why_not);
  if (frames && (frames->empty() ? 0 : frames->back().end()) == size_)
    return Append(bytes::SeekTableOf(*frames), findings);
  return AddCannotWrite(file_, EIO, findings);
}

bool PartFile::Truncate(std::uint64_t size, diag::Findings& findings) {
  if (::ftruncate(descriptor_, static_cast<::off_t>(size)) != 0)
    return AddCannotWrite(file_, errno, findings);
  size_ = size;
  writeback_end_ = size;
  reserved_ = 0;
  checksum_.Clear();
  if (size == 0) return true;
  std::string why_not;
  std::optional<bytes::File> kept = bytes::File::Open(temporary_, why_not);
  if (kept && checksum_.Add(*kept, size, why_not)) return true;
  return AddCannotWrite(file_, EIO, findings);
}

bool PartFile::Sync(diag::Findings& findings) {
  if (::fdatasync(descriptor_) == 0) return true;
  return AddCannotWrite(file_, errno, findings);
}

bool PartFile::Commit(bool if_changed, Durability durability, diag::Findings& findings) {
  if (if_changed && bytes::IsSound(file_, {size_, checksum()})) {
    Drop();
    return true;
  }
  if (!ReleaseReserve()) return AddCannotWrite(file_, errno, findings);
  if (durability == Durability::kBatch && !Sync(findings)) return false;
  if (std::rename(temporary_.c_str(), file_.c_str()) != 0)
    return AddCannotWrite(file_, errno, findings);
  // Closes the file after the renaming, because closing releases the lock, and another process
  // could then open the part by its old name. On a network disk or at a quota, only close() reports
  // that writing failed.
  if (::close(std::exchange(descriptor_, -1)) != 0) return AddCannotWrite(file_, errno, findings);
  return durability == Durability::kNone || SyncFolder(file_.parent_path(), false, findings);
}

void PartFile::Drop() {
  if (descriptor_ < 0) return;
  ::unlink(temporary_.c_str());
  ::close(std::exchange(descriptor_, -1));
}

}  // namespace mjforge::output
