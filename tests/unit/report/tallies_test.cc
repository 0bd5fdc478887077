#include "mjforge/report/tallies.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace mjforge::report {
namespace {

ParameterTally TallyOf(const std::vector<sample::ParameterValue>& values) {
  ParameterTally tally;
  for (const sample::ParameterValue& value : values) tally.Add(value, false);
  return tally;
}

std::string ValuesText(const ParameterTally& tally) {
  std::string text;
  for (const auto& [value, counts] : tally.Values())
    text += value + " " + std::to_string(counts.all) + " ";
  return text;
}

TEST_CASE("texts and booleans have a bar each, in the order of their names") {
  CHECK(ValuesText(TallyOf({std::string("b"), std::string("a"), std::string("b")})) == "a 1 b 2 ");
  CHECK(ValuesText(TallyOf({true, false, true})) == "false 1 true 2 ");
}

TEST_CASE("whole numbers have a bar each while they are few") {
  CHECK(ValuesText(TallyOf({10.0, 2.0, 10.0})) == "2 1 10 2 ");
  std::vector<sample::ParameterValue> many;
  for (std::size_t i = 0; i <= ParameterTally::kMaxWhole; ++i) many.emplace_back(double(i));
  CHECK(TallyOf(many).Values().empty());
  CHECK(TallyOf({1.0, 2.5}).Values().empty());
}

TEST_CASE("tallies joined are the tally of all values") {
  const auto joined = [](const std::vector<sample::ParameterValue>& a,
                         const std::vector<sample::ParameterValue>& b) {
    ParameterTally tally = TallyOf(a);
    tally.Append(TallyOf(b));
    return tally;
  };
  CHECK(ValuesText(joined({std::string("b"), true}, {std::string("b"), std::string("a")})) ==
        "a 1 b 2 true 1 ");
  CHECK(ValuesText(joined({10.0, 2.0}, {10.0})) == "2 1 10 2 ");
  CHECK(joined({1.0}, {2.5}).Values().empty());
  CHECK(joined({2.5}, {1.0}).Values().empty());
  std::vector<sample::ParameterValue> many;
  for (std::size_t i = 0; i <= ParameterTally::kMaxWhole; ++i) many.emplace_back(double(i));
  CHECK(joined({100.0}, many).Values().empty());
  CHECK(joined({std::vector<double>{1, 10}}, {std::vector<double>{3, 20, 5}}).numbers.size() == 3);
}

TEST_CASE("the texts that a sum of tallies lists are counted completely") {
  std::vector<sample::ParameterValue> many;
  for (std::size_t i = 0; i < ParameterTally::kMaxTexts; ++i)
    many.emplace_back("b" + std::to_string(i));
  many.emplace_back("a");  // one too many where it appears, but not in the first tally
  ParameterTally sum = TallyOf({std::string("a")});
  sum.Append(TallyOf(many));
  CHECK(ValuesText(sum).starts_with("a 2 b0 1 "));
  CHECK(sum.Values().size() == ParameterTally::kMaxTexts);
  CHECK(sum.more_texts);
}

TEST_CASE("a vector has a tally for each component") {
  const ParameterTally tally = TallyOf({std::vector<double>{1, 10}, std::vector<double>{3, 20}});
  REQUIRE(tally.numbers.size() == 2);
  CHECK(tally.numbers[0].all.mean() == Approx(2));
  CHECK(tally.numbers[1].all.max() == 20);
  CHECK(tally.Values().empty());
}

TEST_CASE("components are named as expressions write them") {
  const ParameterTally vector = TallyOf({std::vector<double>{1, 10}});
  CHECK(vector.NameOf(1) == vector.name + ".y");
  const ParameterTally list = TallyOf({std::vector<double>{1, 2, 3, 4, 5}});
  CHECK(list.NameOf(4) == list.name + "[4]");
  const ParameterTally number = TallyOf({1.0});
  CHECK(number.NameOf(0) == number.name);
}

TEST_CASE("what is bad is counted apart, too") {
  ParameterTallies tallies;
  tallies.Add({{"size", 0.5}, {"shape", std::string("box")}}, false);
  tallies.Add({{"size", 1.5}, {"shape", std::string("box")}}, true);
  REQUIRE(tallies.list().size() == 2);
  const ParameterTally* size = tallies.Find("size");
  REQUIRE(size != nullptr);
  CHECK(size->numbers[0].all.count() == 2);
  CHECK(size->numbers[0].bad.count() == 1);
  CHECK(size->numbers[0].bad.min() == 1.5);
  CHECK(size->numbers[0].good.count == 1);
  CHECK(size->numbers[0].good.max == 0.5);
  CHECK(size->numbers[0].log_all.count() == 2);
  CHECK(tallies.Find("shape")->Values().front().second.bad == 1);
  CHECK(tallies.Find("none") == nullptr);
}

TEST_CASE("numbers have a mean and a deviation") {
  Statistics numbers;
  for (const double number : {0.1, 0.2, 0.6}) numbers.Add(number);
  CHECK(numbers.count == 3);
  CHECK(numbers.min == 0.1);
  CHECK(numbers.max == 0.6);
  CHECK(numbers.mean == Approx(0.3));
  CHECK(numbers.StandardDeviation() == Approx(std::sqrt((0.04 + 0.01 + 0.09) / 3)));
}

TEST_CASE("parameters are known by name where their place differs") {
  ParameterTallies tallies;
  tallies.Add({{"a", 1.0}, {"b", 2.0}}, false);
  tallies.Add({{"b", 4.0}}, false);
  tallies.Add({{"c", 1.0}, {"a", 3.0}}, false);
  REQUIRE(tallies.list().size() == 3);
  CHECK(tallies.Find("b")->numbers[0].all.mean() == Approx(3));
  CHECK(tallies.Find("a")->numbers[0].all.count() == 2);
}

}  // namespace
}  // namespace mjforge::report
