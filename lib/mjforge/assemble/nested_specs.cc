// Nested specs: sampling of their parameters, and replacement of their materials by materials of
// the outer spec.

#include "mjforge/assemble/assembly.h"

namespace mjforge::assemble {

std::optional<sample::Evaluator> Assembly::SampleNested(Scope& scope, const spec::Entry& entry,
                                                        sample::StreamId path) {
  const sample::StreamId params = sample::Child(path, "params");
  std::vector<std::pair<std::string, sample::ParameterValue>> overrides;
  bool is_good = true;
  for (const auto& [parameter, value] : entry.overrides) {
    auto given = scope.values.Any(value, sample::Child(params, parameter));
    is_good &= given.has_value();
    if (given) overrides.emplace_back(parameter, *std::move(given));
  }
  if (!is_good) return std::nullopt;
  // If drawn values violate the requirements of the nested spec, only the nested spec is drawn
  // again. Its first attempt has the attempt number of the outer spec (DrawKey::attempt).
  return sample::Sample(*entry.nested, scope.values.key(), path, overrides, findings_,
                        scope.values.sampler());
}

void SetSubstitutes(Scope& scope, const spec::Entry& entry, sample::StreamId path, Scope& inner) {
  const sample::StreamId materials = sample::Child(path, "materials");
  inner.outer = &scope;
  for (const auto& [name, value] : entry.substitutes) {
    const sample::StreamId stream = sample::Child(materials, std::string_view(name));
    inner.substitutes.emplace_back(name, scope.values.Text(value, stream).value_or(""));
  }
}

}  // namespace mjforge::assemble
