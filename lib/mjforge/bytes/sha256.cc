// SHA-256 with Libgcrypt.

#include <gcrypt.h>

#include <array>
#include <cstdint>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

constexpr std::size_t kDigestBytes = 32;

// Initializes Libgcrypt, once per process, unless other code already did.
bool GetReady() {
  if (::gcry_control(GCRYCTL_INITIALIZATION_FINISHED_P)) return true;
  ::gcry_check_version(nullptr);
  ::gcry_control(GCRYCTL_DISABLE_SECMEM);
  ::gcry_control(GCRYCTL_INITIALIZATION_FINISHED);
  return true;
}

}  // namespace

// Uses Libgcrypt instead of OpenSSL, whose initialization takes longer than the rest of a short
// command.
std::string Sha256Of(std::string_view bytes) {
  [[maybe_unused]] static const bool kIsReady = GetReady();
  std::array<unsigned char, kDigestBytes> digest;
  ::gcry_md_hash_buffer(GCRY_MD_SHA256, digest.data(), bytes.data(), bytes.size());
  // Each variant is hashed; formatting by fmt would take 3 % of the time of making it.
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(2 * digest.size(), '0');
  for (std::size_t i = 0; i < digest.size(); ++i) {
    text[2 * i] = kDigits[digest[i] >> 4];
    text[2 * i + 1] = kDigits[digest[i] & 15];
  }
  return text;
}

}  // namespace mjforge::bytes
