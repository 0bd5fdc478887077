// Sobol points: equidistribution, agreement with Boost, scrambling.

#include "mjforge/sample/sobol.h"

#include <boost/random/sobol.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "loading.h"

namespace mjforge::sample {
namespace {

std::vector<ParameterStream> Streams(std::size_t count) {
  std::vector<ParameterStream> streams;
  for (std::size_t i = 0; i < count; ++i) {
    streams.push_back({.stream = Child(kRootStream, i), .split = {}});
  }
  return streams;
}

double Coordinate(const Sobol& sobol, std::uint64_t index, StreamId stream) {
  std::array<double, 4> uniforms{};
  sobol.Place(index, stream, uniforms);
  return uniforms[0];
}

std::uint64_t Cell(double u, int bits) { return static_cast<std::uint64_t>(std::ldexp(u, bits)); }

TEST_CASE("2^m points have one in each 2^m-th, in every dimension and block") {
  for (const std::uint64_t seed : {0, 1, 99}) {
    const Sobol sobol(Streams(40), seed);
    for (std::size_t dimension = 0; dimension < 40; ++dimension) {
      const StreamId stream = Child(kRootStream, dimension);
      for (const std::uint64_t first :
           {std::uint64_t{0}, std::uint64_t{256}, std::uint64_t{1} << 40}) {
        std::set<std::uint64_t> cells;
        for (std::uint64_t i = 0; i < 256; ++i) {
          cells.insert(Cell(Coordinate(sobol, first + i, stream), 8));
        }
        CHECK(cells.size() == 256);
      }
    }
  }
}

// The first two dimensions are a (0, 2)-sequence, also after scrambling.
TEST_CASE("the first two dimensions have one point in each box of 1 / 2^m") {
  const Sobol sobol(Streams(2), 7);
  for (int bits = 0; bits <= 8; ++bits) {
    std::set<std::pair<std::uint64_t, std::uint64_t>> boxes;
    for (std::uint64_t i = 0; i < 256; ++i) {
      boxes.emplace(Cell(Coordinate(sobol, i, Child(kRootStream, std::size_t{0})), bits),
                    Cell(Coordinate(sobol, i, Child(kRootStream, std::size_t{1})), 8 - bits));
    }
    CHECK(boxes.size() == 256);
  }
}

// Nested scrambling preserves the number of leading digits that two points have in common.
TEST_CASE("the points are Boost's before scrambling") {
  constexpr std::size_t kDimensions = 60;
  constexpr std::uint64_t kPoints = 64;
  boost::random::sobol engine(kDimensions);
  std::vector<std::vector<std::uint64_t>> original(kDimensions, {0});  // point 0, which Boost skips
  for (std::uint64_t i = 1; i < kPoints; ++i) {
    for (auto& coordinates : original) coordinates.push_back(engine());
  }
  const Sobol sobol(Streams(kDimensions), 5);
  const auto common = [](std::uint64_t a, std::uint64_t b) {
    return std::min(52, std::countl_zero(a ^ b));
  };
  for (std::size_t d = 0; d < kDimensions; ++d) {
    std::vector<std::uint64_t> ours;
    for (std::uint64_t i = 0; i < kPoints; ++i) {
      const std::uint64_t gray = i ^ (i >> 1);  // Boost's order
      ours.push_back(Cell(Coordinate(sobol, gray, Child(kRootStream, d)), 52) << 12);
    }
    for (std::uint64_t i = 0; i < kPoints; ++i) {
      for (std::uint64_t j = 0; j < i; ++j) {
        REQUIRE(common(ours[i], ours[j]) == common(original[d][i], original[d][j]));
      }
    }
  }
}

TEST_CASE("each seed and each stream is scrambled in its own way") {
  std::vector<ParameterStream> streams = Streams(3);
  std::set<double> firsts;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Sobol sobol(streams, seed);
    for (const ParameterStream& stream : streams)
      firsts.insert(Coordinate(sobol, 0, stream.stream));
  }
  CHECK(firsts.size() == 1500);
  double mean = 0;
  for (const double first : firsts) mean += first / 1500;
  CHECK(std::abs(mean - 0.5) < 5 * std::sqrt(1.0 / 12 / 1500));
}

TEST_CASE("the first dimensions are the same however many there are") {
  const Sobol few(Streams(3), 4);
  const Sobol many(Streams(300), 4);
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const StreamId stream = Child(kRootStream, d);
      CHECK(Coordinate(few, i, stream) == Coordinate(many, i, stream));
    }
  }
}

TEST_CASE("points beyond 2^32, and the last one of all, are inside") {
  const Sobol sobol(Streams(100), 4);
  for (std::size_t d = 0; d < 100; ++d) {
    const StreamId stream = Child(kRootStream, d);
    std::set<double> different;
    for (const std::uint64_t index : {std::uint64_t{1} << 32, std::uint64_t{1} << 51,
                                      ~std::uint64_t{0} - 1, ~std::uint64_t{0}}) {
      const double u = Coordinate(sobol, index, stream);
      CHECK(u > 0);
      CHECK(u < 1);
      different.insert(u);
    }
    CHECK(different.size() == 4);
  }
}

TEST_CASE("dimensions without direction numbers stay as they are") {
  const Sobol sobol(Streams(kMostSobolDimensions + 5), 4);
  CHECK(Coordinate(sobol, 9, Child(kRootStream, kMostSobolDimensions - 1)) > 0);
  CHECK(Coordinate(sobol, 9, Child(kRootStream, kMostSobolDimensions)) == 0);
  CHECK(Coordinate(sobol, 9, Child(kRootStream, std::size_t{99999})) == 0);
  CHECK(Coordinate(Sobol({}, 1), 9, 5) == 0);
}

}  // namespace
}  // namespace mjforge::sample
