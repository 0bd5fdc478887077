#include <catch2/catch.hpp>
#include <cmath>

#include "mjforge/spec/spec.h"

namespace mjforge::spec {
namespace {

// Loads a spec whose parameter `x` has this value.
std::unique_ptr<ObjectSpec> Load(const std::string& value) {
  diag::Sources sources;
  diag::Findings findings;
  auto spec = LoadSpecText("a.yaml",
                           "mjforge: 1\nname: a\nparams: {n: 1 .. 2, x: " + value +
                               "}\nparts: [{name: b, type: sphere, size: 1}]\n",
                           ".", {}, sources, findings);
  INFO(value);
  REQUIRE(spec != nullptr);
  return spec;
}

std::optional<Bounds> BoundsOfText(const std::string& value) {
  const auto spec = Load(value);
  return BoundsOf(spec->FindParameter("x")->value);
}

TEST_CASE("the bounds of a number are those of its distribution, its options or itself") {
  CHECK(BoundsOfText("1cm .. 2cm")->low == Approx(0.01));
  CHECK(BoundsOfText("1cm .. 2cm")->high == Approx(0.02));
  CHECK(BoundsOfText("{normal: [1, 2]}")->high == HUGE_VAL);
  CHECK(BoundsOfText("{normal: [1, 2], clip: [0, 3]}")->high == 3);
  CHECK(BoundsOfText("{choice: [1 .. 2, 7, 3]}")->low == 1);
  CHECK(BoundsOfText("{choice: [1 .. 2, 7, 3]}")->high == 7);
  CHECK(BoundsOfText("2 * 3")->low == 6);
}

TEST_CASE("numbers that depend on others, and other values, have no bounds") {
  for (const char* value : {"n", "2 * n", "n .. 3", "{choice: [a, b]}", "true", "[1, 2]"}) {
    INFO(value);
    CHECK_FALSE(BoundsOfText(value).has_value());
  }
}

TEST_CASE("the components of a vector have bounds if all of them do") {
  const auto known = Load("[1, 2 .. 3]");
  const std::vector<Bounds> bounds = BoundsOfComponents(known->FindParameter("x")->value);
  REQUIRE(bounds.size() == 2);
  CHECK(bounds[1].high == 3);
  CHECK(BoundsOfComponents(Load("[1, n]")->FindParameter("x")->value).empty());
}

}  // namespace
}  // namespace mjforge::spec
