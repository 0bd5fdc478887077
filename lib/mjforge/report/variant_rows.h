// Rows of the table of variants in a report.

#pragma once

#include <string>
#include <vector>

#include "mjforge/report/page_sections.h"
#include "mjforge/report/report.h"

namespace mjforge::report {

/// HTML of the rows for the variants that a page shows, and numbers of these variants by the reason
/// why they are shown.
struct VariantRows {
  std::string html;
  std::size_t failed = 0;
  std::size_t slow = 0;
  std::size_t sampled = 0;
  std::size_t without_picture = 0;  // shown variants with a file but no picture
  std::size_t left_out = 0;         // chosen variants that the page has no room for

  std::size_t shown() const { return failed + slow + sampled; }
};

/// Makes rows for the chosen variants until the rows fill `room` bytes: for the failed variants,
/// the slow variants, then the sample. If the sample does not fit, the shown part of the sample is
/// spread over the batch.
VariantRows MakeVariantRows(const std::vector<ShownVariant>& chosen, const Batch& batch,
                            const Request& request, const Thumbnailer& thumbnailer,
                            std::size_t room);

/// Returns the command that regenerates a variant.
std::string ReplayCommand(const Request& request, std::uint64_t index);

}  // namespace mjforge::report
