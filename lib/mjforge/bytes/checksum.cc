// XXH3 checksums of bytes and files, and comparison of files with recorded checksums.

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

constexpr std::uint64_t kReadBufferBytes = 256 * 1024;

// Returns the number of fingerprints in `prefixes` before the first one that does not match the
// beginning of the file; sets `why_not` if the file cannot be read.
std::size_t CountMatching(const std::filesystem::path& file, std::span<const Fingerprint> prefixes,
                          std::string& why_not) {
  std::optional<File> opened = File::Open(file, why_not);
  if (!opened) return 0;
  Checksum checksum;
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < prefixes.size(); ++i) {
    const std::uint64_t end = prefixes[i].size;
    if (end < at || !checksum.Add(*opened, end - at, why_not)) return i;
    if (checksum.Text() != prefixes[i].checksum) return i;
    at = end;
  }
  return prefixes.size();
}

}  // namespace

struct Checksum::State {
  XXH3_state_t hash;
};

Checksum::Checksum() : state_(std::make_unique<State>()) { Clear(); }
Checksum::~Checksum() = default;

void Checksum::Add(std::string_view bytes) {
  XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size());
}

bool Checksum::Add(File& file, std::uint64_t count, std::string& why_not) {
  std::string buffer(std::min(count, kReadBufferBytes), '\0');
  while (count > 0) {
    const std::span<char> wanted = std::span(buffer).first(std::min(count, kReadBufferBytes));
    const std::optional<std::size_t> got = file.Read(wanted, why_not);
    if (!got || *got < wanted.size()) return false;
    Add({wanted.data(), wanted.size()});
    count -= wanted.size();
  }
  return true;
}

std::string Checksum::Text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(&state_->hash);
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

void Checksum::Clear() { XXH3_128bits_reset(&state_->hash); }

std::string ChecksumOf(std::string_view bytes) {
  Checksum checksum;
  checksum.Add(bytes);
  return checksum.Text();
}

std::string HashOf(std::string_view bytes) { return ChecksumOf(bytes).substr(0, kHashDigits); }

std::size_t CountSound(const std::filesystem::path& file, std::span<const Fingerprint> prefixes) {
  std::string ignored;
  return CountMatching(file, prefixes, ignored);
}

Soundness Compare(const std::filesystem::path& file, const Fingerprint& whole,
                  std::string& why_not) {
  if (!HasSize(file, whole.size, why_not)) return Soundness::kChanged;
  why_not.clear();
  if (CountMatching(file, {&whole, 1}, why_not) == 1) return Soundness::kSound;
  if (!why_not.empty()) return Soundness::kUnreadable;
  why_not = "its bytes are others";
  return Soundness::kChanged;
}

bool IsSound(const std::filesystem::path& file, const Fingerprint& whole) {
  std::string ignored;
  return Compare(file, whole, ignored) == Soundness::kSound;
}

}  // namespace mjforge::bytes
