// Archives: a member of a file that says it is a .tar or .tar.zst.

#include "mjforge/output/archive.h"
#include <array>
#include <cstdio>

#include "fuzz/input.h"

namespace mjforge::fuzz {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kMagicAt = 257;
constexpr std::size_t kSumAt = 148;

// With the checksums of headers, without which no changed header would be read.
std::string WithSums(std::string bytes) {
  for (std::size_t at = 0; at + kBlock <= bytes.size(); at += kBlock) {
    if (bytes.compare(at + kMagicAt, 5, "ustar") != 0) continue;
    bytes.replace(at + kSumAt, 8, 8, ' ');
    unsigned sum = 0;
    for (std::size_t i = 0; i < kBlock; ++i) sum += static_cast<unsigned char>(bytes[at + i]);
    std::array<char, 8> octal = {};
    std::snprintf(octal.data(), octal.size(), "%06o", sum);
    bytes.replace(at + kSumAt, octal.size(), octal.data(), octal.size());
  }
  return bytes;
}

}  // namespace

void Run(Input input) {
  const std::filesystem::path file = Put("x.tar", WithSums(std::string(input.Rest())));
  diag::Sources sources;
  diag::Findings findings;
  const auto bytes = output::ReadMember(file, "x_000000.xml", findings);
  Must(bytes.has_value() != findings.HasErrors(), "no member and no error, or both");
  Word(findings, sources);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
