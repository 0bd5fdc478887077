#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

constexpr std::uint64_t kReadBufferBytes = 256 * 1024;

}  // namespace

struct Checksum::State {
  XXH3_state_t hash;
};

Checksum::Checksum() : state_(std::make_unique<State>()) { Clear(); }
Checksum::~Checksum() = default;

void Checksum::Add(std::string_view bytes) {
  XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size());
}

std::string Checksum::Text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->hash);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

void Checksum::Clear() { XXH3_128bits_reset(&state_->hash); }

std::size_t CountSound(const std::filesystem::path& file, std::span<const Prefix> prefixes) {
  std::string why_not;
  std::optional<File> opened = File::Open(file, why_not);
  if (!opened) return 0;
  Checksum checksum;
  std::string buffer(kReadBufferBytes, '\0');
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < prefixes.size(); ++i) {
    while (at < prefixes[i].size) {
      const std::span<char> wanted =
          std::span(buffer).first(std::min(kReadBufferBytes, prefixes[i].size - at));
      const std::optional<std::size_t> count = opened->Read(wanted, why_not);
      if (!count || *count < wanted.size()) return i;
      checksum.Add({wanted.data(), *count});
      at += *count;
    }
    if (at != prefixes[i].size || checksum.Text() != prefixes[i].checksum) return i;
  }
  return prefixes.size();
}

bool HasSize(const std::filesystem::path& file, std::uint64_t size, std::string& why_not) {
  if (!MayRead(file, ~std::uint64_t{0}, why_not)) return false;
  std::error_code error;
  const std::uint64_t found = std::filesystem::file_size(file, error);
  if (!error && found == size) return true;
  why_not = error ? error.message() : fmt::format("it has {} bytes, not {}", found, size);
  return false;
}

bool IsSound(const std::filesystem::path& file, const Prefix& whole, std::string& why_not) {
  if (!HasSize(file, whole.size, why_not)) return false;
  if (CountSound(file, {&whole, 1}) == 1) return true;
  why_not = "its bytes are others";
  return false;
}

}  // namespace mjforge::bytes
