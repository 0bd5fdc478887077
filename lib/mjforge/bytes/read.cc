// Reading of regular files and standard input within limits, kinds of paths, writing to
// descriptors, and the pixel count of PNG files.

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

std::string Words(int error) { return std::generic_category().message(error); }

// Returns the reason why a file of this mode is not a regular file; empty for a regular file.
std::string_view WhyNotRegular(::mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "it is a folder";
  if (S_ISFIFO(mode)) return "it is a pipe";
  if (S_ISSOCK(mode)) return "it is a socket";
  return "it is a device";
}

bool IsRegular(const struct stat& status, std::string& why_not) {
  why_not = WhyNotRegular(status.st_mode);
  return why_not.empty();
}

// Returns the size of a regular file. Returns nullopt, and sets `why_not`, for other files.
std::optional<std::uint64_t> SizeOf(const std::filesystem::path& file, std::string& why_not) {
  struct stat status;
  if (::stat(file.c_str(), &status) != 0) {
    why_not = Words(errno);
    return std::nullopt;
  }
  if (!IsRegular(status, why_not)) return std::nullopt;
  return static_cast<std::uint64_t>(status.st_size);
}

std::string TooLong(std::uint64_t limit) {
  return limit >= 1 << 20 ? fmt::format("it has more than {} MiB", limit >> 20)
                          : fmt::format("it has more than {} bytes", limit);
}

std::optional<std::size_t> ReadFrom(int descriptor, std::span<char> buffer, std::string& why_not) {
  std::size_t count = 0;
  while (count < buffer.size()) {
    const ssize_t got = ::read(descriptor, buffer.data() + count, buffer.size() - count);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      why_not = Words(errno);
      return std::nullopt;
    }
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  return count;
}

// Returns the first `limit` bytes of standard input. Keeps them for later calls, because several
// callers may read standard input.
std::optional<std::string> ReadStandardInput(std::uint64_t limit, std::string& why_not) {
  static std::string text;
  static bool at_end = false;
  while (!at_end && text.size() < limit) {
    std::array<char, 16 * 1024> buffer;
    const std::size_t wanted = std::min<std::uint64_t>(buffer.size(), limit - text.size());
    const std::optional<std::size_t> count =
        ReadFrom(STDIN_FILENO, std::span(buffer).first(wanted), why_not);
    if (!count) return std::nullopt;
    text.append(buffer.data(), *count);
    at_end = *count < wanted;
  }
  return text.substr(0, limit);
}

}  // namespace

std::optional<File> File::Open(const std::filesystem::path& file, std::string& why_not) {
  // Checks the kind of the file before opening it, because opening a pipe blocks, and opening a
  // device may have a side effect.
  if (!SizeOf(file, why_not)) return std::nullopt;
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  if (descriptor < 0) {
    why_not = Words(errno);
    return std::nullopt;
  }
  File opened(descriptor);
  // Checks the opened file, too, because another file may have replaced it since the first check.
  struct stat status;
  if (::fstat(descriptor, &status) != 0) {
    why_not = Words(errno);
    return std::nullopt;
  }
  return IsRegular(status, why_not) ? std::optional(std::move(opened)) : std::nullopt;
}

File::File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

File& File::operator=(File&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

File::~File() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<std::size_t> File::Read(std::span<char> buffer, std::string& why_not) {
  return ReadFrom(descriptor_, buffer, why_not);
}

void File::Seek(std::uint64_t offset) {
  ::lseek(descriptor_, static_cast<::off_t>(offset), SEEK_SET);
}

std::optional<std::string> ReadStart(const std::filesystem::path& file, std::uint64_t limit,
                                     std::string& why_not) {
  if (file == kStandardInput) return ReadStandardInput(limit, why_not);
  std::optional<File> opened = File::Open(file, why_not);
  if (!opened) return std::nullopt;
  std::string text;
  while (text.size() < limit) {
    constexpr std::uint64_t kLeast = 16 * 1024;
    const std::size_t size = text.size();
    text.resize(std::min(limit, size + std::max<std::uint64_t>(size, kLeast)));
    const std::span<char> room = std::span(text).subspan(size);
    const std::optional<std::size_t> count = opened->Read(room, why_not);
    if (!count) return std::nullopt;
    text.resize(size + *count);
    if (*count < room.size()) break;
  }
  return text;
}

std::optional<std::string> Read(const std::filesystem::path& file, std::uint64_t limit,
                                std::string& why_not) {
  std::optional<std::string> text = ReadStart(file, limit + 1, why_not);
  if (text && text->size() > limit) {
    why_not = TooLong(limit);
    return std::nullopt;
  }
  return text;
}

std::optional<std::uint64_t> PngPixels(const std::filesystem::path& file, std::string& why_not) {
  // ISO/IEC 15948, 5.2 and 11.2.2: the signature is followed by the chunk IHDR, whose data begin
  // with width and height as four-byte big-endian numbers.
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t kWidth = 16;
  constexpr std::size_t kHeight = 20;
  const std::optional<std::string> start = ReadStart(file, kHeight + 4, why_not);
  if (!start || !start->starts_with(kSignature)) return std::nullopt;
  if (start->size() < kHeight + 4) return 0;
  const auto number = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (const char byte : start->substr(at, 4))
      value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  };
  return number(kWidth) * number(kHeight);
}

bool Exists(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

bool IsFile(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

bool IsFolder(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored);
}

bool WriteAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool MayRead(const std::filesystem::path& file, std::uint64_t limit, std::string& why_not) {
  if (file == kStandardInput) return true;
  const std::optional<std::uint64_t> size = SizeOf(file, why_not);
  if (size && *size > limit) why_not = TooLong(limit);
  return size && *size <= limit;
}

std::string PipeHint(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_fifo(file, ignored) ? "'-' stands for standard input" : "";
}

bool HasSize(const std::filesystem::path& file, std::uint64_t size, std::string& why_not) {
  const std::optional<std::uint64_t> found = SizeOf(file, why_not);
  if (found && *found != size) why_not = fmt::format("it has {} bytes, not {}", *found, size);
  return found == size;
}

}  // namespace mjforge::bytes
