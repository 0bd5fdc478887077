// Independence of the parameters' draws, overrides, requirements of one draw.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "loading.h"

namespace mjforge::sample {
namespace {

using Overrides = std::vector<std::pair<std::string, ParameterValue>>;
using Values = std::map<std::string, ParameterValue>;

Values AllOf(Family& family, DrawKey key, const Overrides& overrides = {}) {
  Evaluator evaluator(*family.spec, key, kRootStream, family.findings);
  evaluator.SampleParameters(overrides);
  Values values;
  for (std::size_t i = 0; i < family.spec->parameters.size(); ++i) {
    values[family.spec->parameters[i].name] = evaluator.Parameter(i);
  }
  return values;
}

const char* const kParameters =
    "{shape: {choice: [box, ball]}, r: 1 .. 2, l: {normal: [0, 1]}, "
    "v: [0 .. 1, 2 .. 3], on: {bernoulli: 0.5}, d: 2 * r}";

TEST_CASE("adding a parameter changes no other draw") {
  Family family = Load(kParameters);
  Family more = Load("{extra: 5 .. 6, " + std::string(kParameters).substr(1));
  for (std::uint64_t index = 0; index < 50; ++index) {
    Values values = AllOf(more, {.seed = 4, .index = index});
    values.erase("extra");
    REQUIRE(values == AllOf(family, {.seed = 4, .index = index}));
  }
}

TEST_CASE("removing a parameter changes no other draw") {
  Family family = Load(kParameters);
  Family fewer =
      Load("{shape: {choice: [box, ball]}, r: 1 .. 2, v: [0 .. 1, 2 .. 3], on: {bernoulli: 0.5}}");
  for (std::uint64_t index = 0; index < 50; ++index) {
    Values values = AllOf(family, {.seed = 4, .index = index});
    values.erase("l");
    values.erase("d");
    REQUIRE(values == AllOf(fewer, {.seed = 4, .index = index}));
  }
}

TEST_CASE("reordering the parameters changes no draw") {
  Family family = Load(kParameters);
  Family other = Load(
      "{d: 2 * r, on: {bernoulli: 0.5}, v: [0 .. 1, 2 .. 3], l: {normal: [0, 1]}, r: 1 .. 2, "
      "shape: {choice: [box, ball]}}");
  for (std::uint64_t index = 0; index < 50; ++index) {
    REQUIRE(AllOf(family, {.seed = 4, .index = index}) ==
            AllOf(other, {.seed = 4, .index = index}));
  }
}

TEST_CASE("pinning a parameter changes no other draw, only what is computed from it") {
  Family family = Load(kParameters);
  const Overrides pinned = {{"r", 7.0}};
  for (std::uint64_t index = 0; index < 50; ++index) {
    Values expected = AllOf(family, {.seed = 4, .index = index});
    expected["r"] = 7.0;
    expected["d"] = 14.0;
    REQUIRE(AllOf(family, {.seed = 4, .index = index}, pinned) == expected);
  }
}

TEST_CASE("variant 41 is the same whatever was made before") {
  Family family = Load(kParameters);
  const Values alone = AllOf(family, {.seed = 4, .index = 41});
  for (std::uint64_t index = 0; index < 41; ++index) AllOf(family, {.seed = 4, .index = index});
  CHECK(AllOf(family, {.seed = 4, .index = 41}) == alone);
}

TEST_CASE("seed, index and attempt each make other draws") {
  Family family = Load("{r: 1 .. 2}");
  const double first = family.Number("r");
  CHECK(family.Number("r", {.seed = 1}) != first);
  CHECK(family.Number("r", {.index = 1}) != first);
  CHECK(family.Number("r", {.attempt = 1}) != first);
}

TEST_CASE("families of different names draw different numbers from one seed") {
  const std::string params = "{r: 0 .. 1, c: {choice: [1, 2, 3, 4, 5, 6, 7, 8], exact: true}}";
  Family mug = Load(params);
  Family bowl = Load(params);
  bowl.spec->name = "bowl";
  for (const Method method : {Method::kRandom, Method::kSobol, Method::kLatin}) {
    const Sampler of_mug(*mug.spec, method, 7, 8);
    const Sampler of_bowl(*bowl.spec, method, 7, 8);
    int same_choices = 0;
    for (std::uint64_t i = 0; i < 8; ++i) {
      const DrawKey key = {.seed = 7, .index = i};
      CHECK(mug.Number("r", key, &of_mug) != bowl.Number("r", key, &of_bowl));
      same_choices += mug.Number("c", key, &of_mug) == bowl.Number("c", key, &of_bowl);
    }
    CHECK(same_choices < 8);
  }
}

TEST_CASE("an object within an object draws from its own root") {
  Family family = Load("{r: 1 .. 2}");
  const StreamId root = Child(Child(Child(kRootStream, "t"), "parts"), "lid");
  Evaluator evaluator(*family.spec, {}, root, family.findings);
  REQUIRE(evaluator.SampleParameters());
  const double u = Uniforms({}, Child(Child(root, "params"), "r"))[0];
  CHECK(evaluator.Parameter(0) == ParameterValue(RoundWithin(1, 2, std::lerp(1, 2, u))));
}

TEST_CASE("overrides of every type replace the parameters' values") {
  Family family =
      Load("{n: 1, b: true, t: box, v: [1, 2], s: v.x + v.y + n, u: \"t == 'x' ? 1 : 0\"}");
  const Values values = AllOf(
      family, {},
      {{"n", 5.0}, {"b", false}, {"t", std::string("x")}, {"v", std::vector<double>{10, 20}}});
  CHECK(values.at("n") == ParameterValue(5.0));
  CHECK(values.at("b") == ParameterValue(false));
  CHECK(values.at("t") == ParameterValue(std::string("x")));
  CHECK(values.at("v") == ParameterValue(std::vector<double>{10, 20}));
  CHECK(values.at("s") == ParameterValue(35.0));
  CHECK(values.at("u") == ParameterValue(1.0));
  CHECK(family.Report() == Strings{});
}

TEST_CASE("an override of another kind than the parameter is found") {
  Family family = Load("{n: 1, b: true, t: box, v: [1, 2]}");
  AllOf(family, {.seed = 7, .index = 3},
        {{"n", std::string("x")}, {"b", 1.0}, {"t", false}, {"v", std::vector<double>{1, 2, 3}}});
  CHECK(family.Report() ==
        Strings{"3:10 sample/bad-argument: parameter 'n' is a number, but its value is text 7/3",
                "3:16 sample/bad-argument: parameter 'b' is true or false, but its value is a "
                "number 7/3",
                "3:25 sample/bad-argument: parameter 't' is text, but its value is true or false "
                "7/3",
                "3:33 sample/bad-argument: parameter 'v' is 2 numbers, but its value is 3 numbers "
                "7/3"});
}

TEST_CASE("a requirement that does not hold rejects the draw") {
  Family family = Load("{a: 1, b: {cycle: [0, 2]}}", "require: [a > 0, b > a]");
  Evaluator first(*family.spec, {.index = 0}, kRootStream, family.findings);
  CHECK(first.SampleParameters() == 1);
  CHECK_FALSE(first.failed());
  Evaluator second(*family.spec, {.index = 1}, kRootStream, family.findings);
  CHECK(second.SampleParameters() == 2);
}

TEST_CASE("a requirement without a value does not hold") {
  Family family = Load("{a: -1}", "require: [sqrt(a) > 0]");
  Evaluator evaluator(*family.spec, {}, kRootStream, family.findings);
  CHECK(evaluator.SampleParameters() == 0);
}

TEST_CASE("a variable set from outside is seen by expressions") {
  Family family = Load("{a: 1, b: a + 1}");
  Evaluator evaluator = family.Evaluator();
  evaluator.SetVariable(family.spec->parameters[0].slot, 10);
  CHECK(evaluator.Number(family.spec->parameters[1].value, 1) == 11);
}

}  // namespace
}  // namespace mjforge::sample
