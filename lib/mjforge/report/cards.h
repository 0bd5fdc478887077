#pragma once

#include <string>
#include <vector>

#include "mjforge/report/report.h"
#include "mjforge/report/sections.h"

namespace mjforge::report {

/// The variants that a page shows, each a row of its table.
struct Cards {
  std::string html;
  std::size_t failed = 0;
  std::size_t slow = 0;
  std::size_t sampled = 0;
  std::size_t without_picture = 0;  // though they have a file
  std::size_t left_out = 0;         // for want of room

  std::size_t shown() const { return failed + slow + sampled; }
};

/// As many of the chosen as fit into `room` bytes: the failed, the slow, then the others, ordered
/// so that the first few, however many, are spread over the batch.
Cards MakeCards(const std::vector<ShownVariant>& chosen, const Batch& batch, const Request& request,
                const Thumbnailer& thumbnailer, std::size_t room);

/// The command that regenerates a variant.
std::string ReplayCommand(const Request& request, std::uint64_t index);

}  // namespace mjforge::report
