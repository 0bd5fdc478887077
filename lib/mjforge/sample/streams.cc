#include <charconv>

#include <Random123/philox.h>
#include <xxhash.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {

StreamId Child(StreamId parent, std::string_view name) {
  return XXH64(name.data(), name.size(), parent);
}

StreamId Child(StreamId parent, std::size_t position) {
  char digits[20];  // enough for 2^64 - 1
  const auto end = std::to_chars(digits, digits + sizeof(digits), position).ptr;
  return Child(parent, std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream) {
  using Philox = r123::Philox4x64;
  const Philox::ctr_type counter = {{key.index, stream, key.attempt, 0}};
  const Philox::key_type philox_key = {{key.seed, 0}};
  const Philox::ctr_type words = Philox()(counter, philox_key);
  std::array<double, 4> uniforms;
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    uniforms[i] = (static_cast<double>(words[i] >> 12) + 0.5) * 0x1p-52;
  }
  return uniforms;
}

}  // namespace mjforge::sample
