// Padding of a family: the geoms and sites that any of its variants has.

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

void Generator::FindSuperset() {
  padding::Superset superset;
  Variant variant;
  for (std::uint64_t i = 0; i < options_.pad; ++i) {
    const std::uint64_t index = options_.layout_first + i;
    Reset(index, 0, variant);
    std::optional<sample::Evaluator> values =
        sample::Sample(*recipe_.spec, {options_.seed, index, 0}, sample::kRootStream, {},
                       variant.findings, &sampler_);
    if (!values) continue;
    std::optional<model::Object> object = Assemble(*values, variant);
    if (!object) continue;
    mjcf::Adapt(*object, options_.target, variant.findings);
    if (!variant.findings.HasErrors()) superset.Add(*object);
  }
  superset_ = std::move(superset);
}

}  // namespace mjforge::forge
