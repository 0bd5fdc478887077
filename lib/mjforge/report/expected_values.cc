// Estimate of the expected distributions of parameters: draws the parameters again with other
// seeds.

#include <algorithm>

#include "mjforge/report/page_sections.h"

namespace mjforge::report {
namespace {

// Number of draws. If thirty bins contain about 700 draws each, the standard error of a bin is 4 %.
constexpr std::uint64_t kSamples = 20'000;
// Largest number of attempts, including rejected draws. Without this limit, a spec that rejects
// most draws would delay the report.
constexpr std::uint64_t kAttempts = 200'000;

// Mask that changes the batch's seed, because the draws must be independent of the batch.
constexpr std::uint64_t kOtherSeed = 0x9e3779b97f4a7c15;

}  // namespace

ParameterTallies DrawParameters(const spec::ObjectSpec& spec, const DrawRange& range) {
  ParameterTallies drawn;
  std::vector<std::pair<std::string, sample::ParameterValue>> params(spec.parameters.size());
  std::uint64_t attempts = 0;
  const double stride = (static_cast<double>(range.span) + 1) / static_cast<double>(kSamples);
  for (std::uint64_t i = 0; i < kSamples && attempts < kAttempts; ++i) {
    const auto offset = static_cast<std::uint64_t>(static_cast<double>(i) * stride);
    const sample::DrawKey key{range.seed + i, range.first + std::min(offset, range.span), 0};
    diag::Findings ignored;
    const auto values = sample::Sample(spec, key, sample::kRootStream, {}, ignored);
    attempts += values ? values->key().attempt + 1 : sample::kMaxAttempts;
    if (!values) continue;
    for (std::size_t p = 0; p < params.size(); ++p)
      params[p] = {spec.parameters[p].name, values->Parameter(p)};
    drawn.Add(params, false);
  }
  return drawn;
}

ParameterTallies DrawExpected(const forge::Recipe& recipe, const ManifestSummary& summary) {
  if (!summary.first) return {};
  const std::uint64_t first = summary.first->index;
  return DrawParameters(*recipe.spec, {.seed = summary.first->seed ^ kOtherSeed,
                                       .first = first,
                                       .span = std::max(summary.last_index, first) - first});
}

}  // namespace mjforge::report
