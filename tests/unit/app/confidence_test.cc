#include "confidence.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace mjforge::app {
namespace {

TEST_CASE("the share that may fail leaves one sample in twenty without a failure") {
  for (const std::uint64_t passed : {1, 2, 20, 300, 3000, 1'000'000}) {
    const double without = std::pow(1 - LargestFailingShare(passed), static_cast<double>(passed));
    CHECK(without == Approx(0.05));
  }
  CHECK(LargestFailingShare(1) == Approx(0.95));
  CHECK(LargestFailingShare(20) == Approx(0.1391).epsilon(1e-3));
}

TEST_CASE("a good sample says what may still fail, and which sample would say more") {
  CHECK(ConfidenceText(2) ==
        "up to 78 % of all variants may still fail (with 95 % confidence); "
        "-n 300 lowers that to 1 %");
  CHECK(ConfidenceText(20) ==
        "up to 14 % of all variants may still fail (with 95 % confidence); "
        "-n 300 lowers that to 1 %");
  CHECK(ConfidenceText(300) ==
        "up to 0.99 % of all variants may still fail (with 95 % confidence); "
        "-n 3000 lowers that to 0.1 %");
  CHECK(ConfidenceText(3000) ==
        "up to 0.1 % of all variants may still fail (with 95 % confidence)");
}

}  // namespace
}  // namespace mjforge::app
