// Uniform numbers by the selected sampling method, and choices with `exact: true`.

#include "mjforge/sample/sampler.h"

#include <algorithm>

#include "mjforge/sample/apportion.h"
#include "mjforge/sample/dimensions.h"
#include "mjforge/sample/grid.h"
#include "mjforge/sample/latin.h"
#include "mjforge/sample/permutation.h"
#include "mjforge/sample/philox.h"
#include "mjforge/sample/sobol.h"

namespace mjforge::sample {
namespace {

constexpr std::array<std::string_view, 4> kNames = {"random", "sobol", "latin", "grid"};

}  // namespace

std::span<const std::string_view> MethodNames() { return kNames; }

std::optional<Method> FindMethod(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Method>(found - kNames.begin());
}

std::string_view MethodName(Method method) { return kNames[static_cast<std::size_t>(method)]; }

bool Sampler::NeedsBatch(const spec::ObjectSpec& spec, Method method) {
  return method == Method::kLatin || method == Method::kGrid || spec.draws.exact;
}

Sampler::Sampler(const spec::ObjectSpec& spec, Method method, std::uint64_t seed,
                 std::uint64_t batch)
    : method_(method),
      batch_(std::min(batch, kMaxBatch)),
      is_random_(method == Method::kRandom || (method != Method::kSobol && batch == 0)),
      needs_batch_(NeedsBatch(spec, method)) {
  if (method == Method::kSobol) sobol_ = std::make_shared<Sobol>(ParameterStreams(spec), seed);
  if (method == Method::kGrid) grid_ = std::make_shared<Grid>(ParameterStreams(spec), batch_);
}

std::array<double, 4> Sampler::Spread(const DrawKey& key, StreamId stream) const {
  std::array<double, 4> uniforms = sample::Uniforms(key, stream);
  if (sobol_) {
    sobol_->Place(key.index, stream, uniforms);
  } else if (grid_) {
    grid_->Place(key.index % batch_, stream, uniforms);
  } else {
    PlaceLatin(key, stream, batch_, uniforms);
  }
  return uniforms;
}

std::size_t Sampler::ExactOption(std::span<const double> weights, const DrawKey& key,
                                 StreamId stream) const {
  const auto keys = PhiloxWords(key.seed, key.index / batch_, stream, 0, Purpose::kExact);
  std::uint64_t rank = Permuted(key.index % batch_, batch_, keys[0]);
  const std::vector<std::uint64_t> counts = LargestRemainder(weights, batch_);
  std::size_t option = 0;
  // The loop ends, because the sum of the counts is the size of the batch and `rank` is smaller.
  while (rank >= counts[option]) rank -= counts[option++];
  return option;
}

std::string Sampler::GridText() const { return grid_ ? grid_->Text() : std::string(); }

std::uint64_t Sampler::GridPoints() const { return grid_ ? grid_->points() : 0; }

}  // namespace mjforge::sample
