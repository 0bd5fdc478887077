// Repeated entries: expands `for`, `if` and `let` into instances.

#pragma once

#include <functional>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Expands the entries of one object into instances. Loops are nested, the first variable
/// outermost; `let` and `if` are evaluated for each instance.
class Repetition {
 public:
  explicit Repetition(diag::Findings& findings) : findings_(findings) {}

  /// Returns the number of instances, ignoring conditions; nullopt after a finding, for instance if
  /// there are too many together with the `existing` elements.
  std::optional<std::size_t> Count(const spec::Entry& entry, sample::Evaluator& values,
                                   std::size_t existing);
  /// Calls `visit` for each instance that exists, with its variables and local values set. Local
  /// values are drawn from the stream of the instance's name in `list`. Stops after an instance
  /// with an error, because the others would fail in the same way.
  template <typename Visit>
  void ForEach(const spec::Entry& entry, sample::Evaluator& values, sample::StreamId list,
               const Visit& visit) {
    Walk(entry, 0, values, list, std::cref(visit));  // a reference allocates no memory
  }

 private:
  /// Returns the number of instances of the loops from `depth` on, ignoring conditions; -1 after a
  /// finding.
  long CountInstances(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
                      long limit);
  bool Walk(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
            sample::StreamId list, const std::function<void()>& visit);

  diag::Findings& findings_;
  long steps_ = 0;  // number of instances so far, existing or not
};

}  // namespace mjforge::assemble
