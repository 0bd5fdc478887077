#include <openssl/evp.h>

#include <array>
#include <memory>

#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

std::string Hexadecimal(const unsigned char* bytes, unsigned int count) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(std::size_t{2} * count);
  for (unsigned int i = 0; i < count; ++i) {
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  return text;
}

}  // namespace

std::string Sha256(std::string_view bytes) {
  // Looking the algorithm up and making a context cost more than hashing an
  // object's few kilobytes, so each thread does it once.
  thread_local const auto context = [] {
    std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> made(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    EVP_DigestInit_ex(made.get(), EVP_sha256(), nullptr);
    return made;
  }();
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  EVP_DigestInit_ex(context.get(), nullptr, nullptr);  // the same algorithm again
  EVP_DigestUpdate(context.get(), bytes.data(), bytes.size());
  EVP_DigestFinal_ex(context.get(), digest.data(), &size);
  return Hexadecimal(digest.data(), size);
}

}  // namespace mjforge::output
