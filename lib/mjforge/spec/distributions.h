// Distributions of draws: keys in a spec, arguments and options.

#pragma once

#include <span>
#include <string_view>

namespace mjforge::spec {

/// A kind of draw. A spec describes a draw by a mapping in which the name of the distribution is a
/// key: {normal: [0, 1]}.
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
  int arguments;  // count of numbers in the argument list; -1: any count of values of any type
  std::string_view usage;        // "{triangular: [lo, mode, hi]}"
  std::string_view option = {};  // additional key: "clip", "range" or "weights"
  std::string_view doc = {};
  std::string_view flag = {};  // additional key for true or false: "exact"
};
std::span<const DistributionInfo> Distributions();

}  // namespace mjforge::spec
