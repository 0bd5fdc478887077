#pragma once

// The distributions of the language, a table like that of the fields.

#include <span>
#include <string_view>

namespace mjforge::spec {

/// One kind of random draw, as a mapping's first key.
enum class Distribution {
  kUniform,
  kLogUniform,
  kTriangular,
  kNormal,
  kLogNormal,
  kBeta,
  kExponential,
  kPoisson,
  kInteger,
  kBernoulli,
  kChoice,
  kCycle,
};

struct DistributionInfo {
  std::string_view key;
  Distribution id;
  int arguments;                 // numbers it takes; -1: any number of values of any kind
  std::string_view usage;        // "{triangular: [lo, mode, hi]}"
  std::string_view option = {};  // extra key: "clip", "range" or "weights"
  std::string_view doc = {};
  std::string_view flag = {};  // extra key that is true or false: "exact"
};
std::span<const DistributionInfo> Distributions();

}  // namespace mjforge::spec
