#include "mjforge/batch/spread.h"

#include <fmt/format.h>

namespace mjforge::batch {

void CheckSpread(const forge::Recipe& recipe, const Request& request, diag::Findings& findings) {
  const forge::Options& options = request.variant;
  const std::uint64_t size = options.batch;
  const sample::Sampler sampler(*recipe.spec, options.sampler, options.seed, size);
  if (!sampler.NeedsBatch() || size == 0) return;
  if (request.first % size != 0 && request.first % size + request.count > size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("variants {} to {} lie in several blocks of {}: draws are spread "
                              "evenly over each block, not over these variants",
                              request.first, request.first + (request.count - 1), size),
                  fmt::format("let --first be a multiple of {}", size));
  }
  const std::uint64_t points = sampler.GridPoints();
  if (points > size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("the grid has {}, of which {} variants are only the first",
                              sampler.GridText(), size),
                  "make more variants, or pin a parameter with --set");
  } else if (points > 0 && points < size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("the grid has {}; the last {} of {} variants repeat some",
                              sampler.GridText(), size - points, size),
                  fmt::format("-n {} has each of them once", points));
  }
}

}  // namespace mjforge::batch
