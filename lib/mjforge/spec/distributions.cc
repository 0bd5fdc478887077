// The table of random distributions.

#include "mjforge/spec/distributions.h"

namespace mjforge::spec {
namespace {

constexpr DistributionInfo kDistributions[] = {
    {"uniform", Distribution::kUniform, 2, "{uniform: [lo, hi]}", "",
     "Every value between lo and hi is equally likely; `lo .. hi` for short."},
    {"log_uniform", Distribution::kLogUniform, 2, "{log_uniform: [lo, hi]}", "",
     "The logarithm is uniform; 0 < lo <= hi."},
    {"triangular", Distribution::kTriangular, 3, "{triangular: [lo, mode, hi]}", "",
     "Most likely at the mode, linearly less likely towards lo and hi."},
    {"normal", Distribution::kNormal, 2, "{normal: [mean, std], clip: [lo, hi]}", "clip",
     "The normal distribution; with `clip` truncated exactly."},
    {"log_normal", Distribution::kLogNormal, 2, "{log_normal: [mu, sigma], clip: [lo, hi]}", "clip",
     "The logarithm is normal with mean mu and standard deviation sigma; clip as above."},
    {"beta", Distribution::kBeta, 2, "{beta: [a, b], range: [lo, hi]}", "range",
     "The beta distribution on [lo, hi], or on [0, 1] without `range`."},
    {"exponential", Distribution::kExponential, 1, "{exponential: rate}", "clip",
     "Waiting times; the mean is 1 / rate. May have `clip`."},
    {"poisson", Distribution::kPoisson, 1, "{poisson: mean}", "clip", "Counts. May have `clip`."},
    {"integer", Distribution::kInteger, 2, "{integer: [lo, hi]}", "",
     "Every whole number from lo to hi, both included, is equally likely."},
    {"bernoulli", Distribution::kBernoulli, 1, "{bernoulli: p}", "", "True with probability p."},
    {"choice", Distribution::kChoice, -1, "{choice: [a, b, ...], weights: [...], exact: true}",
     "weights",
     "One of the values, which may be of any kind; equally likely, or by weights. With `exact: "
     "true` the counts over a batch follow the weights.",
     "exact"},
    {"cycle", Distribution::kCycle, -1, "{cycle: [a, b, ...]}", "",
     "The value at the variant's index modulo the list's length."},
};

}  // namespace

std::span<const DistributionInfo> Distributions() { return kDistributions; }

}  // namespace mjforge::spec
