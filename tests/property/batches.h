// Comparison of batches that make the same variants in several ways.

#pragma once

#include <cstdint>
#include <string>

#include "purity.h"

namespace mjforge::batch {

/// Makes the variants 0 to `count - 1` as one batch of one worker. Fails the test if a byte differs
/// from the files of: three workers, three merged shards, a batch that was stopped and resumed, a
/// batch of half the variants that was resumed with all of them, a batch that lost a file and was
/// resumed, and a variant that was made alone. Each batch is written to a folder, or as a series of
/// archives in it if `is_series` is set. At least one variant must be valid. Returns true if the
/// batch that was to be stopped did not finish earlier.
bool CompareBatches(forge::Loaded& loaded, const forge::Options& options, std::uint64_t count,
                    bool is_series);

}  // namespace mjforge::batch
