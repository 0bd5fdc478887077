#include "mjforge/output/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "mjforge/output/atomic_file.h"

namespace mjforge::output {
namespace {

bool IsSameFile(int descriptor, const std::filesystem::path& path) {
  struct stat opened;
  struct stat named;
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

bool HaveSameBytes(const std::filesystem::path& a, const std::filesystem::path& b) {
  struct stat status_a;
  struct stat status_b;
  if (::stat(a.c_str(), &status_a) != 0 || ::stat(b.c_str(), &status_b) != 0) return false;
  if (!S_ISREG(status_b.st_mode) || status_a.st_size != status_b.st_size) return false;
  std::FILE* file_a = std::fopen(a.c_str(), "rbe");
  std::FILE* file_b = std::fopen(b.c_str(), "rbe");
  bool same = file_a != nullptr && file_b != nullptr;
  std::array<char, 64 * 1024> buffer_a;
  std::array<char, 64 * 1024> buffer_b;
  while (same) {
    const std::size_t count_a = std::fread(buffer_a.data(), 1, buffer_a.size(), file_a);
    const std::size_t count_b = std::fread(buffer_b.data(), 1, buffer_b.size(), file_b);
    same = std::string_view(buffer_a.data(), count_a) == std::string_view(buffer_b.data(), count_b);
    if (count_a == 0 || std::ferror(file_a) != 0 || std::ferror(file_b) != 0) break;
  }
  if (file_a != nullptr) std::fclose(file_a);
  if (file_b != nullptr) std::fclose(file_b);
  return same;
}

}  // namespace

PartFile::PartFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor,
                   std::uint64_t size)
    : file_(std::move(file)),
      temporary_(std::move(temporary)),
      descriptor_(descriptor),
      size_(size) {}

PartFile::PartFile(PartFile&& other) noexcept
    : file_(std::move(other.file_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

PartFile& PartFile::operator=(PartFile&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(temporary_, other.temporary_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  return *this;
}

PartFile::~PartFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::filesystem::path PartFile::NameOf(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.part", file.filename().string());
}

bool PartFile::Exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(NameOf(file), ignored);
}

std::optional<PartFile> PartFile::Open(const std::filesystem::path& file,
                                       diag::Findings& findings) {
  const std::filesystem::path temporary = NameOf(file);
  while (true) {
    const int descriptor =
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      AddCannotWrite(file, errno, findings);
      return std::nullopt;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);
      findings.Add(diag::Code::kOutputCannotWrite, {},
                   fmt::format("cannot write '{}': another mjforge is writing it", file.string()),
                   "wait for it, or choose another place");
      return std::nullopt;
    }
    // Who had it may have given it its name in between: then this is another file.
    if (!IsSameFile(descriptor, temporary)) {
      ::close(descriptor);
      continue;
    }
    const ::off_t size = ::lseek(descriptor, 0, SEEK_END);
    return PartFile(file, temporary, descriptor, static_cast<std::uint64_t>(size));
  }
}

bool PartFile::Append(std::string_view bytes, diag::Findings& findings) {
  const bool written = WriteAll(descriptor_, bytes, file_, findings);
  if (written) size_ += bytes.size();
  return written;
}

bool PartFile::Truncate(std::uint64_t size, diag::Findings& findings) {
  if (::ftruncate(descriptor_, static_cast<::off_t>(size)) != 0) {
    AddCannotWrite(file_, errno, findings);
    return false;
  }
  size_ = size;
  return true;
}

// The lock goes last: until then nobody else opens the file under its old name.
bool PartFile::Commit(bool if_changed, diag::Findings& findings) {
  if (if_changed && HaveSameBytes(temporary_, file_)) {
    Drop();
    return true;
  }
  if (std::rename(temporary_.c_str(), file_.c_str()) != 0) {
    AddCannotWrite(file_, errno, findings);
    return false;
  }
  // On a network disk or at a quota, only close() says that writing failed.
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    AddCannotWrite(file_, errno, findings);
    ::unlink(file_.c_str());
    return false;
  }
  return true;
}

void PartFile::Drop() {
  if (descriptor_ < 0) return;
  ::unlink(temporary_.c_str());
  ::close(std::exchange(descriptor_, -1));
}

}  // namespace mjforge::output
