#include <algorithm>

#include "mjforge/report/sections.h"

namespace mjforge::report {
namespace {

// Of thirty bins, each holds about 700 of them: a line that is drawn through them is
// off by 4 %.
constexpr std::uint64_t kSamples = 20'000;
// A spec that rejects most draws gets fewer: no report waits for it.
constexpr std::uint64_t kAttempts = 200'000;

// Any number that no batch is likely to have as its seed.
constexpr std::uint64_t kOtherSeed = 0x9e3779b97f4a7c15;

}  // namespace

ParameterTallies Ask(const forge::Recipe& recipe, const Gathered& gathered) {
  const spec::ObjectSpec& spec = *recipe.spec;
  ParameterTallies asked;
  if (!gathered.first) return asked;
  std::vector<std::pair<std::string, sample::ParameterValue>> params(spec.parameters.size());
  std::uint64_t attempts = 0;
  const std::uint64_t span = std::max<std::uint64_t>(
      gathered.last_index >= gathered.first->index ? gathered.last_index - gathered.first->index + 1
                                                   : 1,
      1);
  const double stride = static_cast<double>(span) / static_cast<double>(kSamples);
  for (std::uint64_t i = 0; i < kSamples && attempts < kAttempts; ++i) {
    const auto offset = static_cast<std::uint64_t>(static_cast<double>(i) * stride);
    const sample::DrawKey key{(gathered.first->seed ^ kOtherSeed) + i,
                              gathered.first->index + std::min(offset, span - 1), 0};
    diag::Findings ignored;
    const auto values = sample::Sample(spec, key, sample::kRootStream, {}, ignored);
    attempts += values ? values->key().attempt + 1 : sample::kMaxAttempts;
    if (!values) continue;
    for (std::size_t p = 0; p < params.size(); ++p)
      params[p] = {spec.parameters[p].name, values->Parameter(p)};
    asked.Add(params, false);
  }
  return asked;
}

}  // namespace mjforge::report
