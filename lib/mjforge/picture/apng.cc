#include <zlib.h>

#include <stdexcept>

#include "mjforge/picture/picture.h"

// APNG as in the PNG specification, third edition, section 11.3.6: a PNG file with a
// chunk acTL before its data, and before each frame's data a chunk fcTL. The data
// of the first frame are the file's own (IDAT), those of the others stand in fdAT,
// which begin with a number.

namespace mjforge::picture {
namespace {

constexpr std::size_t kSignature = 8;  // bytes
constexpr std::size_t kHeader = 8;     // of a chunk: length, type

void AppendNumber(std::string& out, std::uint32_t number, int bytes = 4) {
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
    out += static_cast<char>(number >> shift & 0xFF);
}

void AppendChunk(std::string& out, std::string_view type, std::string_view data) {
  AppendNumber(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.append(type).append(data);
  const auto* bytes = reinterpret_cast<const Bytef*>(out.data() + start);
  AppendNumber(
      out, static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<uInt>(out.size() - start))));
}

// The chunk at `at`, which moves on.
struct Chunk {
  std::string_view type;
  std::string_view data;
  std::string_view whole;
};
Chunk Next(std::string_view png, std::size_t& at) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<std::uint8_t>(png[at + i]);
  Chunk chunk{png.substr(at + 4, 4), png.substr(at + kHeader, length),
              png.substr(at, kHeader + length + 4)};
  at += chunk.whole.size();
  return chunk;
}

void AppendControl(std::string& out, const Image& image, int delay, std::uint32_t& number) {
  std::string data;
  AppendNumber(data, number++);
  AppendNumber(data, static_cast<std::uint32_t>(image.width));
  AppendNumber(data, static_cast<std::uint32_t>(image.height));
  AppendNumber(data, 0);  // x
  AppendNumber(data, 0);  // y
  AppendNumber(data, static_cast<std::uint32_t>(delay), 2);
  AppendNumber(data, 1000, 2);
  AppendNumber(data, 0, 1);  // it stays,
  AppendNumber(data, 0, 1);  // and takes the place of what was there
  AppendChunk(out, "fcTL", data);
}

}  // namespace

std::string EncodeApng(std::span<const Image> frames, int delay, const Texts& texts) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  std::string out;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string png = EncodePng(frames[i], i == 0 ? texts : Texts());
    if (i == 0) out = png.substr(0, kSignature);
    bool controlled = false;
    for (std::size_t at = kSignature; at < png.size();) {
      const Chunk chunk = Next(png, at);
      const bool data = chunk.type == "IDAT";
      if (data && i == 0 && !controlled) {
        std::string all;
        AppendNumber(all, static_cast<std::uint32_t>(frames.size()));
        AppendNumber(all, 0);  // for ever
        AppendChunk(out, "acTL", all);
      }
      if (data && !controlled) AppendControl(out, frames[i], delay, number);
      controlled = controlled || data;
      if (data && i > 0) {
        std::string numbered;
        AppendNumber(numbered, number++);
        AppendChunk(out, "fdAT", numbered.append(chunk.data));
      } else if (i == 0 && chunk.type != "IEND") {
        out.append(chunk.whole);
      }
    }
  }
  AppendChunk(out, "IEND", {});
  return out;
}

}  // namespace mjforge::picture
