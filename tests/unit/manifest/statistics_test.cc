#include <catch2/catch.hpp>
#include <cmath>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

Record RecordOf(double height, const std::string& kind, double mass) {
  Record record;
  record.status = "ok";
  record.params = {{"height", height}, {"kind", kind}};
  record.mass_properties.mass = mass;
  return record;
}

TEST_CASE("statistics of numbers are their count, ends, mean and deviation") {
  Statistics statistics;
  for (const double height : {0.1, 0.2, 0.6}) statistics.Add(RecordOf(height, "box", 10 * height));
  const std::vector<Statistics::Parameter> parameters = statistics.Parameters();
  REQUIRE(parameters.size() == 2);
  REQUIRE(parameters[0].numbers.size() == 1);
  const Statistics::Numbers& height = parameters[0].numbers[0];
  CHECK(height.count == 3);
  CHECK(height.min == 0.1);
  CHECK(height.max == 0.6);
  CHECK(height.mean == Approx(0.3));
  CHECK(height.StandardDeviation() == Approx(std::sqrt((0.04 + 0.01 + 0.09) / 3)));
  CHECK(parameters[0].values.empty());
  CHECK(statistics.mass().mean == Approx(3));
}

TEST_CASE("texts, booleans and few whole numbers are counted one by one") {
  Statistics statistics;
  for (int i = 0; i < 6; ++i) {
    Record record = RecordOf(i % 3, i % 2 == 0 ? "box" : "rod", 1);
    record.params.emplace_back("round", i == 0);
    statistics.Add(record);
  }
  const std::vector<Statistics::Parameter> parameters = statistics.Parameters();
  using Values = std::vector<std::pair<std::string, std::uint64_t>>;
  CHECK(parameters[0].values == Values{{"0", 2}, {"1", 2}, {"2", 2}});
  CHECK(parameters[1].values == Values{{"box", 3}, {"rod", 3}});
  CHECK(parameters[2].values == Values{{"false", 5}, {"true", 1}});
}

TEST_CASE("many whole numbers are only numbers, and many texts are cut off") {
  Statistics statistics;
  for (int i = 0; i < 1200; ++i) statistics.Add(RecordOf(i, "text" + std::to_string(i), 1));
  const std::vector<Statistics::Parameter> parameters = statistics.Parameters();
  CHECK(parameters[0].values.empty());
  CHECK(parameters[0].numbers[0].count == 1200);
  CHECK(parameters[1].values.size() == Statistics::kMaxValues);
  CHECK(parameters[1].more_values);
}

TEST_CASE("a vector has numbers for each component") {
  Statistics statistics;
  Record record;
  record.status = "ok";
  record.params = {{"size", std::vector<double>{1, 2, 3}}};
  statistics.Add(record);
  const std::vector<Statistics::Parameter> parameters = statistics.Parameters();
  REQUIRE(parameters[0].numbers.size() == 3);
  CHECK(parameters[0].numbers[2].mean == 3);
}

TEST_CASE("failed variants count by status and code, and their values do not") {
  Statistics statistics;
  statistics.Add(RecordOf(1, "box", 1));
  Record failed = RecordOf(9, "rod", 9);
  failed.status = "failed";
  failed.findings = {R"({"code":"model/bad-value"})", R"({"code":"model/bad-value"})"};
  statistics.Add(failed);
  CHECK(statistics.variants() == 2);
  CHECK(statistics.statuses().at("ok") == 1);
  CHECK(statistics.statuses().at("failed") == 1);
  CHECK(statistics.codes().at("model/bad-value") == 1);
  CHECK(statistics.Parameters()[0].numbers[0].max == 1);
}

}  // namespace
}  // namespace mjforge::manifest
