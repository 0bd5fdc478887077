// Tests of the numbers that represent texts.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <string>

#include "mjforge/expr/expr.h"

using mjforge::expr::TextKey;

TEST_CASE("a text's key is its XXH64 with 52 bits") {
  // XXH64 of nothing is 0xef46db3751d8e999.
  CHECK(TextKey("") == static_cast<double>(0x6db3751d8e999));
  CHECK(TextKey("box") == TextKey(std::string("box")));
  CHECK(TextKey("box") != TextKey("Box"));
}

TEST_CASE("keys are whole numbers and different texts have different ones") {
  std::set<double> keys;
  for (int i = 0; i < 10'000; ++i) {
    const double key = TextKey("wall_" + std::to_string(i));
    CHECK(key == std::floor(key));
    keys.insert(key);
  }
  CHECK(keys.size() == 10'000);
}
