// The table of random distributions.

#pragma once

#include <span>
#include <string_view>

namespace mjforge::spec {

/// A kind of random draw; its name is a key of the mapping that describes the draw.
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
  int arguments;                 // count of numbers that it takes; -1: any count of any values
  std::string_view usage;        // "{triangular: [lo, mode, hi]}"
  std::string_view option = {};  // extra key: "clip", "range" or "weights"
  std::string_view doc = {};
  std::string_view flag = {};  // extra key that is true or false: "exact"
};
std::span<const DistributionInfo> Distributions();

}  // namespace mjforge::spec
