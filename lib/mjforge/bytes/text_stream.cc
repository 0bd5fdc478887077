// Reading of the bytes of a text file, and their decompression if the file is compressed.

#include "mjforge/bytes/text_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace mjforge::bytes {

TextStream::TextStream(File file, bool is_compressed, const FileSection& section)
    : file_(std::move(file)),
      position_(section.begin),
      end_(section.end),
      decoder_(is_compressed ? ZSTD_createDCtx() : nullptr) {
  file_.Seek(position_);
  if (!is_compressed) return;
  if (decoder_ == nullptr) throw std::bad_alloc();
  stored_.resize(ZSTD_DStreamInSize());
}

std::optional<std::size_t> TextStream::Read(std::span<char> buffer, std::string& why_not) {
  const std::optional<std::size_t> count =
      decoder_ == nullptr ? ReadStored(buffer, why_not) : Decompress(buffer, why_not);
  if (is_after_section_) bytes_after_section_ += count.value_or(0);
  return count;
}

std::optional<std::size_t> TextStream::ReadStored(std::span<char> buffer, std::string& why_not) {
  is_after_section_ = position_ >= end_;
  if (!is_after_section_)
    buffer = buffer.first(std::min<std::uint64_t>(buffer.size(), end_ - position_));
  const std::optional<std::size_t> count = file_.Read(buffer, why_not);
  position_ += count.value_or(0);
  is_at_end_ = count.value_or(0) == 0;
  return count;
}

std::optional<std::size_t> TextStream::Decompress(std::span<char> buffer, std::string& why_not) {
  while (true) {
    if (input_.pos == input_.size && !has_output_) {
      const std::optional<std::size_t> count = ReadStored(stored_, why_not);
      if (!count) return std::nullopt;
      if (is_at_end_ && is_in_frame_) why_not = "its last frame is incomplete";
      if (is_at_end_) return is_in_frame_ ? std::nullopt : std::optional<std::size_t>(0);
      input_ = {stored_.data(), *count, 0};
    }
    ZSTD_outBuffer output = {buffer.data(), buffer.size(), 0};
    const std::size_t hint = ZSTD_decompressStream(decoder_.get(), &output, &input_);
    if (ZSTD_isError(hint) != 0) {
      why_not = fmt::format("it is damaged (Zstandard: {})", ZSTD_getErrorName(hint));
      return std::nullopt;
    }
    is_in_frame_ = hint != 0;
    has_output_ = is_in_frame_ && output.pos == output.size;
    if (output.pos > 0) return output.pos;
  }
}

}  // namespace mjforge::bytes
