// Tests that samplers spread a batch more evenly than random draws and keep every distribution.

#include <catch2/catch.hpp>
#include <cmath>

#include "goodness.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

std::unique_ptr<spec::ObjectSpec> Load(const std::string& params) {
  diag::Sources sources;
  diag::Findings findings;
  auto spec = spec::LoadSpecText("t.yaml",
                                 "mjforge: 1\nname: t\nparams: " + params +
                                     "\nparts: [{name: b, type: box, size: [1, 1, 1]}]\n",
                                 ".", {}, sources, findings);
  REQUIRE(spec != nullptr);
  return spec;
}

// Returns the parameter values of items 0 .. count - 1, one row per item.
std::vector<std::vector<double>> Rows(const spec::ObjectSpec& spec, Method method,
                                      std::uint64_t seed, std::uint64_t count) {
  const Sampler sampler(spec, method, seed, count);
  std::vector<std::vector<double>> rows;
  for (std::uint64_t index = 0; index < count; ++index) {
    diag::Findings findings;
    const auto values =
        Sample(spec, {.seed = seed, .index = index}, kRootStream, {}, findings, &sampler);
    REQUIRE(values);
    std::vector<double>& row = rows.emplace_back();
    for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
      row.push_back(std::get<double>(values->Parameter(i)));
    }
  }
  return rows;
}

// Centred L2 discrepancy of points in the unit cube. Source: Hickernell, "A generalized
// discrepancy and quadrature error bound", Math. Comp. 67, 1998, equation 5.1c.
double CentredDiscrepancy(const std::vector<std::vector<double>>& points) {
  const auto n = static_cast<double>(points.size());
  const std::size_t dimensions = points.front().size();
  double single = 0;
  double pairs = 0;
  for (const auto& x : points) {
    double product = 1;
    for (const double c : x) {
      const double d = std::abs(c - 0.5);
      product *= 1 + d / 2 - d * d / 2;
    }
    single += product;
    for (const auto& y : points) {
      double both = 1;
      for (std::size_t k = 0; k < dimensions; ++k) {
        both *= 1 + std::abs(x[k] - 0.5) / 2 + std::abs(y[k] - 0.5) / 2 - std::abs(x[k] - y[k]) / 2;
      }
      pairs += both;
    }
  }
  return std::sqrt(std::pow(13.0 / 12, static_cast<double>(dimensions)) - 2 / n * single +
                   pairs / n / n);
}

std::string UniformParameters(int dimensions) {
  std::string params;
  for (int i = 0; i < dimensions; ++i) {
    params += (i == 0 ? "{p" : ", p") + std::to_string(i) + ": 0 .. 1";
  }
  return params + "}";
}

TEST_CASE("the discrepancy of one point in the middle is as the formula has it") {
  // (13/12)^s - 2 + 1
  CHECK(CentredDiscrepancy({{0.5}}) == Approx(std::sqrt(1.0 / 12)));
  CHECK(CentredDiscrepancy({{0.5, 0.5}}) == Approx(std::sqrt(13.0 * 13 / 144 - 1)));
}

TEST_CASE("sobol and latin batches have a lower discrepancy than random ones") {
  for (const int dimensions : {1, 2, 3, 5, 8}) {
    const auto spec = Load(UniformParameters(dimensions));
    for (const std::uint64_t count : {32, 100, 256}) {
      INFO(dimensions << " dimensions, " << count << " points");
      double random = 0;
      double latin = 0;
      double sobol = 0;
      constexpr std::uint64_t kSeeds = 8;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        const double one = CentredDiscrepancy(Rows(*spec, Method::kRandom, seed, count));
        const double other = CentredDiscrepancy(Rows(*spec, Method::kSobol, seed, count));
        CHECK(other < one);
        random += one;
        sobol += other;
        latin += CentredDiscrepancy(Rows(*spec, Method::kLatin, seed, count));
      }
      // Latin evens out each dimension by itself, which helps less in many dimensions.
      CHECK(latin < 0.95 * random);
      CHECK(sobol < 0.7 * random);
      if (dimensions > 1) CHECK(sobol < latin);
    }
  }
}

TEST_CASE("every method leaves the distributions what they are") {
  const auto spec = Load(
      "{u: -1 .. 3, n: {normal: [1, 2]}, t: {triangular: [0, 1, 4]}, e: {exponential: 3}, "
      "l: {log_uniform: [1, 100]}, c: {normal: [0, 1], clip: [0, 9]}}");
  const std::vector<std::function<double(double)>> below = {
      [](double x) { return (x + 1) / 4; },
      [](double x) { return std::erfc(-(x - 1) / 2 / std::sqrt(2.0)) / 2; },
      [](double x) { return x < 1 ? x * x / 4 : 1 - (4 - x) * (4 - x) / 12; },
      [](double x) { return 1 - std::exp(-3 * x); },
      [](double x) { return std::log(x) / std::log(100); },
      [](double x) { return std::erf(x / std::sqrt(2.0)); }};
  for (const Method method : {Method::kRandom, Method::kSobol, Method::kLatin}) {
    const auto rows = Rows(*spec, method, 3, 3000);
    for (std::size_t i = 0; i < below.size(); ++i) {
      std::vector<double> sample;
      for (const auto& row : rows) sample.push_back(row[i]);
      INFO(MethodName(method) << " " << spec->parameters[i].name);
      CHECK(KolmogorovSmirnov(sample, below[i]) > kLevel);
      for (std::size_t j = 0; j < i; ++j) {
        std::vector<double> other;
        for (const auto& row : rows) other.push_back(row[j]);
        CHECK(std::abs(Correlation(sample, other)) < 0.07);
      }
    }
  }
}

// Collects one item of the batches of many seeds: each item is uniform although the batch is
// planned.
TEST_CASE("over the seeds, each item of a planned batch is uniform") {
  const auto spec = Load(UniformParameters(2));
  const auto identity = [](double x) { return x; };
  for (const Method method : {Method::kSobol, Method::kLatin}) {
    for (const std::uint64_t index : {0, 1, 13}) {
      std::vector<double> first;
      std::vector<double> second;
      for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        const Sampler sampler(*spec, method, seed, 20);
        diag::Findings findings;
        const auto values =
            Sample(*spec, {.seed = seed, .index = index}, kRootStream, {}, findings, &sampler);
        first.push_back(std::get<double>(values->Parameter(0)));
        second.push_back(std::get<double>(values->Parameter(1)));
      }
      INFO(MethodName(method) << " item " << index);
      CHECK(KolmogorovSmirnov(first, identity) > kLevel);
      CHECK(KolmogorovSmirnov(second, identity) > kLevel);
      CHECK(std::abs(Correlation(first, second)) < 0.07);
    }
  }
}

}  // namespace
}  // namespace mjforge::sample
