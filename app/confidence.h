// Largest share of all variants that may fail, concluded from a sample of variants without failure.
#pragma once

#include <cstdint>
#include <string>

namespace mjforge::app {

/// Returns, with a confidence of 95 %, the largest share of all variants that may fail if none of
/// `passed` (at least 1) random variants failed: the one-sided bound of Clopper and Pearson.
double LargestFailingShare(std::uint64_t passed);

/// Returns a sentence about all variants of a spec, after `passed` variants and no failure: the
/// largest share that may fail, in percent, and the number of variants that would lower this share.
std::string ConfidenceText(std::uint64_t passed);

}  // namespace mjforge::app
