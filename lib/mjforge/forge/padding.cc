// Search for the geoms and sites that any variant of a family has, to pad all variants with.

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

std::shared_ptr<const padding::Superset> Generator::FindSuperset(const std::atomic<bool>* stop) {
  const auto superset = std::make_shared<padding::Superset>();
  const std::uint64_t attempts =
      options_.on_invalid == OnInvalid::kResample ? kMaxResamples + 1 : 1;
  Variant variant;
  for (std::uint64_t i = 0; i < options_.pad; ++i) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) break;
    const std::uint64_t index = options_.layout_first + i;
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
      const std::optional<model::Object> object = Unpadded(index, attempt, variant);
      if (!object) continue;
      superset->Add(*object);
      break;
    }
  }
  return superset;
}

std::optional<model::Object> Generator::Unpadded(std::uint64_t index, std::uint64_t attempt,
                                                 Variant& variant) {
  Reset(index, attempt, variant);
  std::optional<sample::Evaluator> values =
      sample::Sample(*recipe_.spec, {options_.seed, index, attempt}, sample::kRootStream, {},
                     variant.findings, &sampler_);
  if (!values) return std::nullopt;
  std::optional<model::Object> object = Assemble(*values, variant);
  if (!object) return std::nullopt;
  mjcf::Adapt(*object, options_.target, variant.findings);
  if (variant.findings.HasErrors()) return std::nullopt;
  return object;
}

}  // namespace mjforge::forge
