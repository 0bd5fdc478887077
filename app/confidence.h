// Conclusions from a sample of variants about all variants.
#pragma once

#include <cstdint>
#include <string>

namespace mjforge::app {

/// Returns the largest share of all variants that may fail if none of `passed` (at least 1) random
/// variants failed, with a confidence of 95 %: the one-sided bound of Clopper and Pearson.
double LargestFailingShare(std::uint64_t passed);

/// Returns what `passed` variants, of which none failed, say about all variants: the largest share
/// that may fail, in percent, and the number of variants that would make it smaller.
std::string ConfidenceText(std::uint64_t passed);

}  // namespace mjforge::app
