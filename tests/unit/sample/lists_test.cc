// Lists, shuffles, samples and records.

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "loading.h"
#include "mjforge/sample/dimensions.h"

namespace mjforge::sample {
namespace {

using NumberList = std::vector<double>;
using TextList = std::vector<std::string>;

NumberList NumbersOf(Family& family, std::string_view name, DrawKey key) {
  return std::get<NumberList>(family.Parameter(name, key));
}

TextList TextsOf(Family& family, std::string_view name, DrawKey key) {
  return std::get<TextList>(family.Parameter(name, key));
}

TEST_CASE("each value of a list has a path of its own") {
  Family five = Load("{w: {each: 1 .. 2, count: 5}}");
  Family six = Load("{other: 0 .. 1, w: {each: 1 .. 2, count: 6}}");
  for (std::uint64_t index = 0; index < 20; ++index) {
    const NumberList shorter = NumbersOf(five, "w", {3, index, 0});
    NumberList longer = NumbersOf(six, "w", {3, index, 0});
    REQUIRE(shorter.size() == 5);
    REQUIRE(longer.size() == 6);
    CHECK(std::set<double>(longer.begin(), longer.end()).size() == 6);
    longer.pop_back();
    CHECK(shorter == longer);
  }
}

TEST_CASE("the length of a list may be drawn, and be zero") {
  Family family = Load("{n: {integer: [0, 3]}, w: {each: n + 1, count: n}}");
  std::set<std::size_t> lengths;
  for (std::uint64_t index = 0; index < 50; ++index) {
    const NumberList list = NumbersOf(family, "w", {1, index, 0});
    CHECK(static_cast<double>(list.size()) == family.Number("n", {1, index, 0}));
    for (const double value : list) CHECK(value == static_cast<double>(list.size()) + 1);
    lengths.insert(list.size());
  }
  CHECK(lengths == std::set<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("each makes a list of booleans, each drawn for itself") {
  Family family = Load(
      "{there: {each: {bernoulli: 0.25}, count: 4}, n: sum(there), last: 'there[3]', "
      "copy: {shuffle: there}, fixed: [true, 'there[0]']}");
  double sum = 0;
  for (std::uint64_t index = 0; index < 500; ++index) {
    const DrawKey key = {1, index, 0};
    const auto there = std::get<std::vector<bool>>(family.Parameter("there", key));
    REQUIRE(there.size() == 4);
    const auto count = static_cast<double>(std::ranges::count(there, true));
    CHECK(family.Parameter("n", key) == ParameterValue(count));
    CHECK(family.Parameter("last", key) == ParameterValue(bool(there[3])));
    auto copy = std::get<std::vector<bool>>(family.Parameter("copy", key));
    CHECK(std::ranges::count(copy, true) == std::ranges::count(there, true));
    CHECK(family.Parameter("fixed", key) == ParameterValue(std::vector<bool>{true, there[0]}));
    sum += count;
  }
  CHECK(sum / 2000 == Approx(0.25).margin(0.03));
  CHECK(family.Report().empty());
}

TEST_CASE("a shuffled list has all items, and one item more leaves the order of the others") {
  Family four = Load("{c: {shuffle: [red, green, blue, white]}}");
  Family five = Load("{c: {shuffle: [red, green, blue, white, black]}}");
  std::set<TextList> orders;
  for (std::uint64_t index = 0; index < 500; ++index) {
    const TextList order = TextsOf(four, "c", {1, index, 0});
    orders.insert(order);
    TextList longer = TextsOf(five, "c", {1, index, 0});
    std::erase(longer, "black");
    CHECK(order == longer);
  }
  CHECK(orders.size() == 24);
}

TEST_CASE("a sample has different items") {
  Family family =
      Load("{l: [1, 2, 3, 4, 5, 6], s: {sample: l, count: 2}, v: {shuffle: [7, 8, 9]}}");
  std::set<NumberList> seen;
  for (std::uint64_t index = 0; index < 500; ++index) {
    const NumberList pair = NumbersOf(family, "s", {1, index, 0});
    REQUIRE(pair.size() == 2);
    CHECK(pair[0] != pair[1]);
    seen.insert(pair);
    NumberList three = NumbersOf(family, "v", {1, index, 0});
    std::ranges::sort(three);
    CHECK(three == NumberList{7, 8, 9});
  }
  CHECK(seen.size() == 30);
}

TEST_CASE("lists are chosen, copied, and used in expressions") {
  Family family = Load(
      "{l: {choice: [[1, 2, 3, 4, 5], [6], [7, 8]]}, m: l, s: sum(m), n: len(l), "
      "t: [oak, pine], i: 1, u: '${t[i]}', v: 't[i - 1]', k: \"t[0] == 'oak' ? 1 : 2\"}");
  std::set<double> sums;
  for (std::uint64_t index = 0; index < 50; ++index) {
    const DrawKey key = {1, index, 0};
    CHECK(NumbersOf(family, "l", key) == NumbersOf(family, "m", key));
    CHECK(family.Number("n", key) == static_cast<double>(NumbersOf(family, "l", key).size()));
    sums.insert(family.Number("s", key));
  }
  CHECK(sums == std::set<double>{6, 15});
  CHECK(std::get<std::string>(family.Parameter("u")) == "pine");
  CHECK(std::get<std::string>(family.Parameter("v")) == "oak");
  CHECK(family.Number("k") == 1);
}

TEST_CASE("what a list cannot be is told when it is drawn") {
  CHECK(ReportOf("{n: {integer: [2, 2]}, w: {each: 1, count: n - 3}}") ==
        Strings{"3:52 sample/bad-argument: count is -1; it must be a whole number, 0 to 100000 "
                "7/3"});
  CHECK(ReportOf("{n: {integer: [4, 4]}, l: [1, 2, 3, 4, 5], s: {sample: l, count: n + 2}}") ==
        Strings{"3:74 sample/bad-argument: 6 different items are asked of a list that has 5 7/3"});
  CHECK(ReportOf("{l: [1, 2, 3, 4, 5], i: {integer: [5, 5]}, a: 'l[i]'}") ==
        Strings{"3:55 expr/out-of-range: there is no l[5]: 'l' has 5 values, counted from 0 (here "
                "i = 5, l = [1, 2, 3, 4, 5]) 7/3"});
}

TEST_CASE("a record is one draw: columns follow the key") {
  Family family = Load(
      "{style: {choice: [{name: modern, leg: 3 .. 4, wood: oak}, {name: rustic, leg: 6 .. 8, wood: "
      "pine}], weights: [3, 1]}, twice: 2 * style.leg}");
  int modern = 0;
  for (std::uint64_t index = 0; index < 400; ++index) {
    const DrawKey key = {1, index, 0};
    const auto name = std::get<std::string>(family.Parameter("style.name", key));
    const double leg = family.Number("style.leg", key);
    const bool is_modern = name == "modern";
    modern += is_modern ? 1 : 0;
    CHECK(leg >= (is_modern ? 3 : 6));
    CHECK(leg <= (is_modern ? 4 : 8));
    CHECK(std::get<std::string>(family.Parameter("style.wood", key)) ==
          (is_modern ? "oak" : "pine"));
    CHECK(family.Number("twice", key) == 2 * leg);
  }
  CHECK(modern > 260);
  CHECK(modern < 340);
}

TEST_CASE("one row more moves no draw of the others") {
  Family two = Load("{s: {choice: [{name: b, leg: 3 .. 4}, {name: c, leg: 6 .. 8}]}}");
  Family three =
      Load("{s: {choice: [{name: a, leg: 0}, {name: b, leg: 3 .. 4}, {name: c, leg: 6 .. 8}]}}");
  int same = 0;
  for (std::uint64_t index = 0; index < 200; ++index) {
    const DrawKey key = {1, index, 0};
    if (two.Parameter("s.name", key) != three.Parameter("s.name", key)) continue;
    ++same;
    CHECK(two.Number("s.leg", key) == three.Number("s.leg", key));
  }
  CHECK(same > 30);
}

TEST_CASE("rows without a name have numbers") {
  Family family = Load("{s: {cycle: [{a: 1, b: 5}, {a: 1, b: 6}]}}");
  CHECK(family.Number("s.row", {1, 0, 0}) == 0);
  CHECK(family.Number("s.b", {1, 0, 0}) == 5);
  CHECK(family.Number("s.row", {1, 1, 0}) == 1);
  CHECK(family.Number("s.b", {1, 1, 0}) == 6);
}

TEST_CASE("samplers know the values of lists and records") {
  Family family = Load(
      "{a: {each: 1 .. 2, count: 3}, s: {choice: [{n: p, l: 1 .. 2}, {n: q, l: 2}]}, "
      "o: {shuffle: [1, 2, 3, 4, 5]}}");
  const std::vector<ParameterStream> streams = ParameterStreams(*family.spec);
  REQUIRE(streams.size() == 3 + 1 + 1 + 5);
  CHECK(streams[3].levels == 2);
  CHECK(std::ranges::count(streams, true, &ParameterStream::is_order) == 5);
  // In four variants, each quarter of a range has one.
  for (const Method method : {Method::kSobol, Method::kLatin}) {
    const Sampler sampler(*family.spec, method, 5, 4);
    std::set<int> quarters;
    for (std::uint64_t index = 0; index < 4; ++index) {
      const auto list = std::get<NumberList>(family.Parameter("a", {5, index, 0}, &sampler));
      quarters.insert(static_cast<int>((list[2] - 1) * 4));
    }
    CHECK(quarters.size() == 4);
  }
  const Sampler grid(*family.spec, Method::kGrid, 5, 1000);
  CHECK(grid.GridPoints() <= 1000);
}

}  // namespace
}  // namespace mjforge::sample
