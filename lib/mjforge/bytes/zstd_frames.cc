// Writing of Zstandard's frames and seek tables, and finding the frames of a file.

#include "mjforge/bytes/zstd_frames.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <system_error>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

// Level of compression. The compressed texts (records of variants) consist mostly of digits that do
// not repeat, so higher levels are slower and gain nothing.
constexpr int kLevel = 1;

// Number of bytes read at a time to find the frames of a file without a seek table.
constexpr std::uint64_t kPieceBytes = std::uint64_t{4} << 20;

// Zstandard's seekable format 0.1.0: a header (the magic number of a skippable frame, the number of
// bytes that follow), two numbers for each frame (stored and decompressed bytes) and a footer (the
// number of frames, a byte without flags, a magic number). All numbers have 32 bits, little-endian.
constexpr std::uint32_t kTableMagic = 0x184D2A5E;
constexpr std::uint32_t kSeekableMagic = 0x8F92EAB1;
constexpr std::size_t kHeaderBytes = 8;
constexpr std::size_t kEntryBytes = 8;
constexpr std::size_t kFooterBytes = 9;

// The 16 magic numbers of skippable frames differ in their last four bits.
constexpr std::uint32_t kSkippableMask = 0xFFFFFFF0;

void AppendNumber(std::string& out, std::uint32_t number) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(number >> shift & 0xFF);
}

std::uint32_t NumberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

bool IsSkippable(std::string_view frame) {
  return (NumberAt(frame, 0) & kSkippableMask) == (kTableMagic & kSkippableMask);
}

// Returns `count` bytes of the file from `offset` on; fewer if the file ends before. Returns an
// empty text, and sets `why_not`, if reading fails.
std::string BytesAt(File& file, std::uint64_t offset, std::uint64_t count, std::string& why_not) {
  std::string bytes(count, '\0');
  file.Seek(offset);
  bytes.resize(file.Read(bytes, why_not).value_or(0));
  return bytes;
}

// Returns the frames that the seek table at the end of the file lists; nullopt if there is no valid
// table, or if its sizes do not add up to the size of the file.
std::optional<std::vector<Frame>> FromTable(File& file, std::uint64_t size, std::string& why_not) {
  if (size < kHeaderBytes + kFooterBytes) return std::nullopt;
  const std::string footer = BytesAt(file, size - kFooterBytes, kFooterBytes, why_not);
  if (footer.size() < kFooterBytes || NumberAt(footer, 5) != kSeekableMagic || footer[4] != 0)
    return std::nullopt;
  const std::uint64_t count = NumberAt(footer, 0);
  const std::uint64_t body = count * kEntryBytes + kFooterBytes;
  if (body + kHeaderBytes > size) return std::nullopt;
  const std::uint64_t start = size - body - kHeaderBytes;
  const std::string table = BytesAt(file, start, size - start, why_not);
  if (table.size() < size - start || NumberAt(table, 0) != kTableMagic ||
      NumberAt(table, 4) != body) {
    return std::nullopt;
  }
  std::vector<Frame> frames;
  frames.reserve(count);
  std::uint64_t at = 0;
  for (std::size_t i = kHeaderBytes; i < kHeaderBytes + count * kEntryBytes; i += kEntryBytes) {
    frames.push_back({at, NumberAt(table, i), NumberAt(table, i + 4)});
    at = frames.back().end();
  }
  return at == start ? std::optional(std::move(frames)) : std::nullopt;
}

std::vector<Frame> FromWholeFile(File& file, std::uint64_t size, std::string& why_not) {
  std::vector<Frame> frames;
  std::uint64_t at = 0;
  for (std::uint64_t piece = kPieceBytes; at < size && piece <= kMaxFrame;) {
    const std::string bytes = BytesAt(file, at, std::min(piece, size - at), why_not);
    std::string_view left = bytes;
    while (left.size() >= 4) {
      const std::size_t count = ZSTD_findFrameCompressedSize(left.data(), left.size());
      if (ZSTD_isError(count) != 0) break;
      const unsigned long long text = ZSTD_getFrameContentSize(left.data(), left.size());
      const bool is_known = text < std::numeric_limits<std::uint32_t>::max();
      if (!IsSkippable(left)) {
        frames.push_back({at, static_cast<std::uint32_t>(count),
                          is_known ? static_cast<std::uint32_t>(text) : 0});
      }
      at += count;
      left.remove_prefix(count);
    }
    // Doubles the number of bytes to read if the bytes read do not contain a whole frame.
    piece = left.size() == bytes.size() ? 2 * piece : kPieceBytes;
  }
  return frames;
}

}  // namespace

FrameCompressor::FrameCompressor() : context_(ZSTD_createCCtx()) {
  if (context_ == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context_, ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context_, ZSTD_c_checksumFlag, 1);
}

FrameCompressor::~FrameCompressor() { ZSTD_freeCCtx(context_); }

std::string_view FrameCompressor::Compress(std::string_view text) {
  if (text.empty()) return {};
  frame_.resize(ZSTD_compressBound(text.size()));
  const std::size_t size =
      ZSTD_compress2(context_, frame_.data(), frame_.size(), text.data(), text.size());
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();  // the only possible reason
  return std::string_view(frame_).substr(0, size);
}

std::optional<bool> IsCompressed(File& file, std::string& why_not) {
  std::array<char, 4> start = {};
  const std::optional<std::size_t> count = file.Read(start, why_not);
  if (!count) return std::nullopt;
  const std::string_view bytes(start.data(), start.size());
  return NumberAt(bytes, 0) == ZSTD_MAGICNUMBER || IsSkippable(bytes);
}

std::optional<std::vector<Frame>> FramesOf(const std::filesystem::path& file,
                                           std::string& why_not) {
  std::optional<File> opened = File::Open(file, why_not);
  if (!opened) return std::nullopt;
  std::error_code ignored;
  const std::uint64_t size = std::filesystem::file_size(file, ignored);
  std::optional<std::vector<Frame>> frames = FromTable(*opened, size, why_not);
  if (!frames) frames = FromWholeFile(*opened, size, why_not);
  return why_not.empty() ? frames : std::nullopt;
}

std::string SeekTableOf(std::span<const Frame> frames) {
  std::string table;
  AppendNumber(table, kTableMagic);
  AppendNumber(table, static_cast<std::uint32_t>(frames.size() * kEntryBytes + kFooterBytes));
  for (const Frame& frame : frames) {
    AppendNumber(table, frame.bytes);
    AppendNumber(table, frame.text_bytes);
  }
  AppendNumber(table, static_cast<std::uint32_t>(frames.size()));
  table += '\0';
  AppendNumber(table, kSeekableMagic);
  return table;
}

}  // namespace mjforge::bytes
