// Identifiers of random streams (hashes of paths), and the uniform numbers of a stream.

#include <charconv>

#include <xxhash.h>

#include "mjforge/sample/philox.h"
#include "mjforge/sample/streams.h"

namespace mjforge::sample {

StreamId Child(StreamId parent, std::string_view name) {
  return XXH64(name.data(), name.size(), parent);
}

StreamId Child(StreamId parent, std::size_t position) {
  char digits[20];  // enough digits for 2^64 - 1
  const auto end = std::to_chars(digits, digits + sizeof(digits), position).ptr;
  return Child(parent, std::string_view(digits, static_cast<std::size_t>(end - digits)));
}

std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream) {
  const auto words = PhiloxWords(key.seed, key.index, stream, key.attempt, Purpose::kDraw);
  std::array<double, 4> uniforms;
  for (std::size_t i = 0; i < uniforms.size(); ++i) uniforms[i] = UniformOf(words[i]);
  return uniforms;
}

}  // namespace mjforge::sample
