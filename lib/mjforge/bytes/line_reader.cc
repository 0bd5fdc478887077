// Reading of a file line by line through a fixed buffer.

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

constexpr std::size_t kLineBufferBytes = 256 * 1024;

}  // namespace

LineReader::LineReader(File file) : file_(std::move(file)), buffer_(kLineBufferBytes, '\0') {}

std::optional<LineReader> LineReader::Open(const std::filesystem::path& file,
                                           std::string& why_not) {
  std::optional<File> opened = File::Open(file, why_not);
  return opened ? std::optional(LineReader(*std::move(opened))) : std::nullopt;
}

bool LineReader::Next(std::string& line, std::string& why_not) {
  line.clear();
  why_not.clear();
  while (true) {
    if (begin_ == end_ && !at_end_) {
      const std::optional<std::size_t> count = file_.Read(buffer_, why_not);
      begin_ = 0;
      end_ = count.value_or(0);
      at_end_ = end_ == 0;
      if (!count) return false;
    }
    if (at_end_) {
      torn_ = torn_ || !line.empty();
      return !line.empty();
    }
    const char* start = buffer_.data() + begin_;
    const void* found = std::memchr(start, '\n', end_ - begin_);
    const std::size_t length =
        found == nullptr ? end_ - begin_
                         : static_cast<std::size_t>(static_cast<const char*>(found) - start);
    if (line.size() + length > kMaxLine) {
      at_end_ = true;
      why_not = fmt::format("a line has more than {} MiB", kMaxLine >> 20);
      return false;
    }
    line.append(start, length);
    begin_ += length + (found == nullptr ? 0 : 1);
    if (found != nullptr) return true;
  }
}

}  // namespace mjforge::bytes
