// Streams of random numbers: known answers of Philox and XXH64, pinned uniforms.

#include <Random123/philox.h>

#include <catch2/catch.hpp>
#include <set>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

// Returns the centre of the word's cell of width 2^-52.
double Centre(std::uint64_t word) { return (static_cast<double>(word >> 12) + 0.5) / 0x1p52; }

TEST_CASE("the generator gives the known answers of Random123 for Philox4x64-10") {
  struct Known {
    r123::Philox4x64::ctr_type counter;
    r123::Philox4x64::key_type key;
    r123::Philox4x64::ctr_type words;
  };
  constexpr std::uint64_t kOnes = ~std::uint64_t{0};
  const Known all[] = {
      {{{0, 0, 0, 0}},
       {{0, 0}},
       {{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}}},
      {{{kOnes, kOnes, kOnes, kOnes}},
       {{kOnes, kOnes}},
       {{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}}},
      {{{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89}},
       {{0x452821e638d01377, 0xbe5466cf34e90c6c}},
       {{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}}},
  };
  for (const Known& known : all) {
    CHECK(r123::Philox4x64()(known.counter, known.key) == known.words);
  }
}

TEST_CASE("seed 0, index 0, stream 0, attempt 0 gives the known answer of the zero block") {
  const std::array<double, 4> u = Uniforms({}, 0);
  CHECK(u[0] == Centre(0x16554d9eca36314c));
  CHECK(u[1] == Centre(0xdb20fe9d672d0fdc));
  CHECK(u[2] == Centre(0xd7e772cee186176b));
  CHECK(u[3] == Centre(0x7e68b68aec7ba23b));
}

TEST_CASE("the key is the seed, the counter is index, stream, attempt") {
  const DrawKey key = {.seed = 7, .index = 42, .attempt = 3};
  const auto words = r123::Philox4x64()({{42, 99, 3, 0}}, {{7, 0}});
  const std::array<double, 4> u = Uniforms(key, 99);
  for (std::size_t i = 0; i < 4; ++i) CHECK(u[i] == Centre(words[i]));
}

TEST_CASE("uniforms are never 0 or 1") {
  CHECK(Centre(0) == 0x1p-53);
  CHECK(Centre(~std::uint64_t{0}) == 1 - 0x1p-53);
}

TEST_CASE("the first draws of a stream are pinned") {
  const StreamId stream = Child(Child(kRootStream, "params"), "handle_radius");
  CHECK(stream == 0x54329028f73ce054);
  const double pinned[] = {0.6033838639495651,  0.6466964607562903,  0.7962533343233037,
                           0.05330665537632806, 0.24272386311322702, 0.8265203835348233,
                           0.8547536664418912,  0.17941860703035573, 0.3608640744525963,
                           0.36752104225254645};
  for (std::uint64_t index = 0; index < 10; ++index) {
    CHECK(Uniforms({.seed = 1, .index = index}, stream)[0] == pinned[index]);
  }
}

TEST_CASE("a stream's name is hashed with its parent as the seed of XXH64") {
  CHECK(Child(kRootStream, "") == 0xef46db3751d8e999);  // XXH64's own test vector
  CHECK(Child(5, "a") != Child(6, "a"));
  CHECK(Child(5, "a") != Child(5, "b"));
}

TEST_CASE("a position is hashed as its decimal text") {
  CHECK(Child(9, std::size_t{0}) == Child(9, "0"));
  CHECK(Child(9, std::size_t{1207}) == Child(9, "1207"));
  CHECK(Child(9, ~std::size_t{0}) == Child(9, "18446744073709551615"));
}

TEST_CASE("where names are joined matters") {
  CHECK(Child(Child(0, "ab"), "c") != Child(Child(0, "a"), "bc"));
}

TEST_CASE("the streams of many paths differ") {
  std::set<StreamId> streams;
  for (const char* list : {"params", "parts", "sites", "joints"}) {
    for (std::size_t i = 0; i < 1000; ++i) streams.insert(Child(Child(kRootStream, list), i));
  }
  CHECK(streams.size() == 4000);
}

}  // namespace
}  // namespace mjforge::sample
