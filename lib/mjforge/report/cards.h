// Rows of the table of variants.

#pragma once

#include <string>
#include <vector>

#include "mjforge/report/report.h"
#include "mjforge/report/sections.h"

namespace mjforge::report {

/// Rows for the variants that a page shows, and their numbers.
struct Cards {
  std::string html;
  std::size_t failed = 0;
  std::size_t slow = 0;
  std::size_t sampled = 0;
  std::size_t without_picture = 0;  // although the variants have a file
  std::size_t left_out = 0;         // because the page is full

  std::size_t shown() const { return failed + slow + sampled; }
};

/// Makes the rows of the chosen variants until they fill `room` bytes: failed variants, slow ones,
/// then the sample, in an order in which any first part is spread over the batch.
Cards MakeCards(const std::vector<ShownVariant>& chosen, const Batch& batch, const Request& request,
                const Thumbnailer& thumbnailer, std::size_t room);

/// Returns the command that regenerates a variant.
std::string ReplayCommand(const Request& request, std::uint64_t index);

}  // namespace mjforge::report
