// Streams and levels of the draws of parameters.

#include "mjforge/sample/dimensions.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "loading.h"

namespace mjforge::sample {
namespace {

struct Expected {
  std::vector<std::string> path;  // names below params
  int numbers = 1;
  std::uint64_t levels = 0;
};

void CheckStreams(const std::string& params, const std::vector<Expected>& expected) {
  INFO(params);
  const Family family = Load(params);
  const std::vector<ParameterStream> streams = ParameterStreams(*family.spec);
  REQUIRE(streams.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO(i);
    StreamId stream = Child(RootStream(*family.spec), "params");
    for (const std::string& name : expected[i].path) stream = Child(stream, name);
    CHECK(streams[i].stream == stream);
    CHECK(streams[i].numbers == expected[i].numbers);
    CHECK(streams[i].levels == expected[i].levels);
  }
}

TEST_CASE("parameters that draw have streams, in file order") {
  CheckStreams("{b: 0 .. a, c: 3, a: 1 .. 2, d: a + b, t: {normal: [0, 1]}}",
               {{{"b"}}, {{"a"}}, {{"t"}}});
  CheckStreams("{a: 1}", {});
}

TEST_CASE("a draw comes before the draws inside it") {
  CheckStreams("{a: {normal: [0, 1 .. 2], clip: [{uniform: [-2, -1]}, 5 .. 6]}}",
               {{{"a"}}, {{"a", "1"}}, {{"a", "clip", "0"}}, {{"a", "clip", "1"}}});
  CheckStreams("{a: {choice: [1, 2 .. 3], weights: [1, 1 .. 2]}}",
               {{{"a"}}, {{"a", "weights", "1"}}, {{"a", "choice", "1"}}});
  CheckStreams("{a: {cycle: [1, 2 .. 3]}}", {{{"a", "cycle", "1"}}});
  CheckStreams("{a: {choice: [1, 2 .. 3], exact: true}}", {{{"a", "choice", "1"}}});
}

TEST_CASE("whole vectors span as many dimensions as they take numbers") {
  CheckStreams("{a: [0 .. 1, 2, 3 .. 4]}", {{{"a", "0"}}, {{"a", "2"}}});
  CheckStreams("{a: {hsv: [0 .. 1, 1, 0 .. 1]}}", {{{"a", "0"}}, {{"a", "2"}}});
  CheckStreams("{a: {on_sphere: 1 .. 2}}", {{{"a"}, 2}, {{"a", "on_sphere"}}});
  CheckStreams("{a: {about: [0 .. 1, 0, 1]}}", {{{"a"}}, {{"a", "about", "0"}}});
  CheckStreams("{a: {choice: [[0 .. 1, 2], [3, 4]]}}",
               {{{"a"}, 1, 2}, {{"a", "choice", "0", "0"}}});
}

TEST_CASE("discrete draws have levels where their ends are constants") {
  CheckStreams("{a: {choice: [x, y, z]}}", {{{"a"}, 1, 3}});
  CheckStreams("{a: {choice: [x, y], weights: [1, 2]}}", {{{"a"}}});
  CheckStreams("{n: 3, a: {integer: [2, 5]}, b: {integer: [1, n]}, c: {integer: [1, 2 * 3]}}",
               {{{"a"}, 1, 4}, {{"b"}}, {{"c"}, 1, 6}});
  CheckStreams("{a: {bernoulli: 0.5}, b: {bernoulli: 1}, n: 0.5, c: {bernoulli: n}}",
               {{{"a"}, 1, 2}, {{"b"}, 1, 1}, {{"c"}, 1, 2}});
}

// The grid replaces the uniforms of all streams that ParameterStreams() lists. If Evaluator drew
// from any other stream, the values would depend on seed and index.
TEST_CASE("the streams are all that the parameters draw from") {
  Family family = Load(
      "{a: 0 .. 1, b: {normal: [a, 1 .. 2], clip: [0 .. 0.1, 4 .. 5]}, "
      "c: [0 .. 1, 2, {beta: [1, 1 .. 2]}], d: {hsv: [0 .. 1, 0.5, 0 .. 1]}, "
      "e: {on_sphere: 1 .. 2}, f: {about: [0 .. 1, 0, 1]}, "
      "g: {choice: [1 .. 2, {choice: [2 .. 3, 4]}], weights: [1, 0 .. 5]}, "
      "h: {cycle: [0 .. 1, 1 .. 2]}, i: {integer: [1, {integer: [5, 9]}]}, "
      "j: {choice: [[0 .. 1, 2], [3, 4 .. 5]]}}");
  const Sampler grid(*family.spec, Method::kGrid, 1, 1);  // one point: the middle of everything
  for (std::size_t i = 0; i < family.spec->parameters.size(); ++i) {
    INFO(family.spec->parameters[i].name);
    const std::string& name = family.spec->parameters[i].name;
    if (name == "h") continue;  // a cycle depends on the index
    const ParameterValue middle = family.Parameter(name, {.seed = 1, .index = 0}, &grid);
    for (std::uint64_t index = 1; index < 20; ++index) {
      CHECK(family.Parameter(name, {.seed = 1, .index = index}, &grid) == middle);
      CHECK(family.Parameter(name, {.seed = 2, .index = index}, &grid) == middle);
    }
  }
  CHECK(family.Number("h", {.seed = 1, .index = 4}, &grid) == 0.5);
}

}  // namespace
}  // namespace mjforge::sample
