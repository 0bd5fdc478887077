// The values of a spec that another one brings.

#include <algorithm>

#include "mjforge/model/assembly.h"

namespace mjforge::model {
namespace {

// The parameters that an entry sets for its spec.
class Overrides {
 public:
  void Add(const std::string& parameter, sample::Evaluator& values, const spec::Value& value,
           sample::StreamId path) {
    values_.emplace_back(parameter, values.Any(value, path, numbers_.emplace_back()));
  }
  std::span<const std::pair<std::string, sample::ParameterValue>> values() const { return values_; }
  bool Varies(std::string_view parameter) const {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i].first == parameter) return std::ranges::any_of(numbers_[i], &IsOnTape);
    }
    return false;
  }
  /// Takes the values that a tape has now.
  void Update() {
    const auto now = [](const Traced<double>& number) {
      return number.at() != nullptr ? *number.at() : number.value();
    };
    for (std::size_t i = 0; i < values_.size(); ++i) {
      sample::ParameterValue& value = values_[i].second;
      if (auto* number = std::get_if<double>(&value)) *number = now(numbers_[i].front());
      if (auto* list = std::get_if<std::vector<double>>(&value)) {
        std::ranges::transform(numbers_[i], list->begin(), now);
      }
    }
  }

 private:
  static bool IsOnTape(const Traced<double>& number) { return number.tape() != nullptr; }

  std::vector<std::pair<std::string, sample::ParameterValue>> values_;
  std::vector<sample::Numbers> numbers_;  // what they are made of
};

}  // namespace

std::shared_ptr<sample::Evaluator> Assembly::SampleNested(Scope& scope, const spec::Entry& entry,
                                                          sample::StreamId path) {
  const std::size_t before = findings_.size();
  const sample::StreamId params = sample::Child(path, "params");
  Overrides overrides;
  for (const auto& [parameter, value] : entry.overrides) {
    overrides.Add(parameter, scope.values, value, sample::Child(params, parameter));
  }
  if (findings_.size() != before) return nullptr;
  // Its own requirements are retried on their own, from this attempt on.
  auto nested = std::make_shared<sample::Evaluator>(*entry.nested, scope.values.key(), path,
                                                    findings_, scope.values.sampler());
  if (!nested->Sample(scope.values.key(), overrides.values(), findings_)) return nullptr;
  if (tape::Tape* tape = scope.values.tape()) {
    nested->NoteParameters();
    nested->NoteOn(*tape, [&](std::string_view parameter) { return overrides.Varies(parameter); });
    tape->Add([nested, &outer = scope.values, overrides]() mutable {
      diag::Findings findings;  // whatever they say, the variant goes another way
      overrides.Update();
      return nested->Sample(outer.key(), overrides.values(), findings);
    });
  }
  return nested;
}

void HandIn(Scope& scope, const spec::Entry& entry, sample::StreamId path, Scope& inner) {
  const sample::StreamId materials = sample::Child(path, "materials");
  inner.outer = &scope;
  for (const auto& [name, value] : entry.substitutes) {
    const sample::StreamId stream = sample::Child(materials, std::string_view(name));
    inner.substitutes.emplace_back(name, scope.values.Text(value, stream));
  }
}

}  // namespace mjforge::model
