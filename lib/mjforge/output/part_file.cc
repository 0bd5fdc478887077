#include "mjforge/output/part_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
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
  std::error_code error;
  if (!std::filesystem::is_regular_file(b, error) ||
      std::filesystem::file_size(a, error) != std::filesystem::file_size(b, error)) {
    return false;
  }
  using Bytes = std::istreambuf_iterator<char>;
  std::ifstream file_a(a, std::ios::binary);
  std::ifstream file_b(b, std::ios::binary);
  return file_a && file_b && std::equal(Bytes(file_a), Bytes(), Bytes(file_b), Bytes());
}

}  // namespace

PartFile::PartFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor,
                   std::uint64_t size)
    : file_(std::move(file)),
      temporary_(std::move(temporary)),
      descriptor_(descriptor),
      size_(size) {}

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

std::unique_ptr<PartFile> PartFile::Open(const std::filesystem::path& file,
                                         diag::Findings& findings) {
  const std::filesystem::path temporary = NameOf(file);
  while (true) {
    const int descriptor =
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor < 0) {
      AddCannotWrite(file, errno, findings);
      return nullptr;
    }
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor);
      findings.Add(diag::Code::kOutputCannotWrite, {},
                   fmt::format("cannot write '{}': another mjforge is writing it", file.string()),
                   "wait for it, or choose another place");
      return nullptr;
    }
    // Who had it may have given it its name in between: then this is another file.
    if (!IsSameFile(descriptor, temporary)) {
      ::close(descriptor);
      continue;
    }
    const ::off_t size = ::lseek(descriptor, 0, SEEK_END);
    return std::unique_ptr<PartFile>(
        new PartFile(file, temporary, descriptor, static_cast<std::uint64_t>(size)));
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
