#include <openssl/evp.h>

#include <array>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

std::string Hexadecimal(std::span<const unsigned char> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const unsigned char byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

}  // namespace

struct Sha256::State {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context{EVP_MD_CTX_new(),
                                                                  EVP_MD_CTX_free};
};

Sha256::Sha256() : state_(std::make_unique<State>()) {
  EVP_DigestInit_ex(state_->context.get(), EVP_sha256(), nullptr);
}

Sha256::~Sha256() = default;

void Sha256::Add(std::string_view bytes) {
  EVP_DigestUpdate(state_->context.get(), bytes.data(), bytes.size());
}

std::string Sha256::Take() {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned int size = 0;
  EVP_DigestFinal_ex(state_->context.get(), digest.data(), &size);
  EVP_DigestInit_ex(state_->context.get(), nullptr, nullptr);  // the same algorithm again
  return Hexadecimal(std::span(digest).first(size));
}

std::string Sha256Of(std::string_view bytes) {
  // Looking the algorithm up and making a context cost more than hashing an object's few
  // kilobytes, so each thread does it once.
  thread_local Sha256 sha256;
  sha256.Add(bytes);
  return sha256.Take();
}

}  // namespace mjforge::bytes
