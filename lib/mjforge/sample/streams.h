#pragma once

// Random numbers by counter: what is drawn where depends on names, never on
// what was drawn before.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mjforge::sample {

/// Identifies one stream of random numbers: the hash of a value's path.
/// Child(Child(kRootStream, "params"), "radius") is the stream of params/radius.
using StreamId = std::uint64_t;
inline constexpr StreamId kRootStream = 0;
StreamId Child(StreamId parent, std::string_view name);
StreamId Child(StreamId parent, std::size_t position);

struct DrawKey {
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::uint64_t attempt = 0;
};

/// Four independent numbers of the open interval (0, 1): Philox4x64-10 with key
/// (seed, 0) and counter (index, stream, attempt, 0), the top 52 bits of each
/// word, centred (with 53 the last one would round to 1). Source: Salmon et al., "Parallel random
/// numbers: as easy as 1, 2, 3", SC 2011.
std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream);

}  // namespace mjforge::sample
