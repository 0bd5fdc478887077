#pragma once

#include <functional>

#include "mjforge/model/model.h"

namespace mjforge::model {

/// Walks the instances of entries: `for` as an odometer, the first variable outermost; `let` and
/// `if` are evaluated for each instance.
class Repetition {
 public:
  explicit Repetition(diag::Findings& findings) : findings_(findings) {}

  /// The number of instances, ignoring conditions; nothing, and a finding, if it is not a number or
  /// too large together with the `existing` elements.
  std::optional<std::size_t> Count(const spec::Entry& entry, sample::Evaluator& values,
                                   std::size_t existing);
  /// Calls `visit` for each instance that exists, with the variables and local values set; draws
  /// are keyed by the instance's name in `list`. Stops at the first instance with a finding, since
  /// the others would fail in the same way.
  template <typename Visit>
  void ForEach(const spec::Entry& entry, sample::Evaluator& values, sample::StreamId list,
               const Visit& visit) {
    Walk(entry, 0, values, list, std::cref(visit));  // a reference needs no memory of its own
  }

 private:
  /// Instances of the loops from `depth` on, ignoring conditions; -1 after a finding.
  long CountInstances(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
                      long limit);
  bool Walk(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
            sample::StreamId list, const std::function<void()>& visit);

  diag::Findings& findings_;
  long steps_ = 0;  // instances walked, existing or not
};

}  // namespace mjforge::model
