// Reading of a text file line by line through a fixed buffer.

#include <fmt/format.h>

#include <cstring>
#include <system_error>
#include <utility>

#include "mjforge/bytes/bytes.h"
#include "mjforge/bytes/text_stream.h"
#include "mjforge/bytes/zstd_frames.h"

namespace mjforge::bytes {
namespace {

constexpr std::size_t kLineBufferBytes = 256 * 1024;
// Distance in bytes between the offsets that CutsOf returns for a file that is not compressed.
constexpr std::uint64_t kCutBytes = std::uint64_t{256} << 10;

}  // namespace

std::optional<std::vector<std::uint64_t>> CutsOf(const std::filesystem::path& file,
                                                 std::string& why_not) {
  std::optional<File> opened = File::Open(file, why_not);
  const std::optional<bool> is_compressed = opened ? IsCompressed(*opened, why_not) : std::nullopt;
  if (!is_compressed) return std::nullopt;
  std::vector<std::uint64_t> cuts = {0};
  if (*is_compressed) {
    const std::optional<std::vector<Frame>> frames = FramesOf(file, why_not);
    if (!frames) return std::nullopt;
    for (const Frame& frame : *frames) {
      if (frame.begin > 0) cuts.push_back(frame.begin);
    }
    return cuts;
  }
  std::error_code ignored;
  const std::uint64_t size = std::filesystem::file_size(file, ignored);
  for (std::uint64_t cut = kCutBytes; cut < size; cut += kCutBytes) cuts.push_back(cut);
  return cuts;
}

LineReader::LineReader(std::unique_ptr<TextStream> stream, bool skips_first)
    : stream_(std::move(stream)), skips_first_(skips_first), buffer_(kLineBufferBytes, '\0') {}

LineReader::LineReader(LineReader&&) noexcept = default;
LineReader::~LineReader() = default;

std::optional<LineReader> LineReader::Open(const std::filesystem::path& file, std::string& why_not,
                                           const FileSection& section) {
  std::optional<File> opened = File::Open(file, why_not);
  const std::optional<bool> is_compressed = opened ? IsCompressed(*opened, why_not) : std::nullopt;
  if (!is_compressed) return std::nullopt;
  auto stream = std::make_unique<TextStream>(*std::move(opened), *is_compressed, section);
  return LineReader(std::move(stream), section.begin > 0);
}

bool LineReader::Next(std::string& line, std::string& why_not) {
  why_not.clear();
  if (std::exchange(skips_first_, false) && !ReadLine(line, why_not)) return false;
  line.clear();
  if (!Fill(why_not)) return false;
  // Ends the section if bytes behind its end were already consumed, because the next line then
  // belongs to the next section.
  if (stream_->bytes_after_section() > end_ - begin_) return false;
  return ReadLine(line, why_not);
}

// Reads more bytes if the buffer is empty. Returns false at the end of the file and if reading
// fails.
bool LineReader::Fill(std::string& why_not) {
  if (begin_ == end_ && !at_end_) {
    const std::optional<std::size_t> count = stream_->Read(buffer_, why_not);
    begin_ = 0;
    end_ = count.value_or(0);
    at_end_ = end_ == 0;
    is_truncated_ = stream_->ends_in_frame();
  }
  return !at_end_;
}

bool LineReader::ReadLine(std::string& line, std::string& why_not) {
  line.clear();
  while (true) {
    if (!Fill(why_not)) {
      is_truncated_ = is_truncated_ || !line.empty();
      return !line.empty() && why_not.empty();
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
