// Streams of random numbers, identified by the hash of a path.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mjforge::sample {

/// A stream of random numbers, identified by the hash of a value's path, so that no draw depends on
/// earlier draws. Child(Child(kRootStream, "params"), "radius") is the stream of params/radius.
using StreamId = std::uint64_t;
inline constexpr StreamId kRootStream = 0;
StreamId Child(StreamId parent, std::string_view name);
StreamId Child(StreamId parent, std::size_t position);

/// The variant and the attempt to which a draw belongs.
struct DrawKey {
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::uint64_t attempt = 0;
};

/// Returns four independent uniform numbers in (0, 1): Philox4x64-10 with key (seed, 0) and counter
/// (index, stream, attempt, 0). A number is the centre of the cell that the top 52 bits of a word
/// select; with 53 bits, the largest number would be rounded to 1. Source: Salmon et al., "Parallel
/// random numbers: as easy as 1, 2, 3", SC 2011.
std::array<double, 4> Uniforms(const DrawKey& key, StreamId stream);

}  // namespace mjforge::sample
