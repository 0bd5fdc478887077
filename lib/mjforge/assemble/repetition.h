// Repeated entries: expands `for`, `if` and `let` into instances.

#pragma once

#include <functional>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Expands the entries of one object into instances. Loops are nested, the first variable
/// outermost. `let` and `if` are evaluated for each instance.
class Repetition {
 public:
  explicit Repetition(diag::Findings& findings) : findings_(findings) {}

  /// Returns the number of instances, including those that `if` leaves out. Returns nullopt if a
  /// loop is invalid, or if there would be too many elements; `existing` is the number of elements
  /// that the list has already. Adds a finding unless the limit was reported before.
  std::optional<std::size_t> Count(const spec::Entry& entry, sample::Evaluator& values,
                                   std::size_t existing);
  /// Calls `visit` for each instance that exists, after setting its loop variables and local
  /// values. The random stream of local values depends on the stream `list` and on the instance's
  /// name. Stops after an instance with an error, because the other instances would fail in the
  /// same way.
  template <typename Visit>
  void ForEach(const spec::Entry& entry, sample::Evaluator& values, sample::StreamId list,
               const Visit& visit) {
    Walk(entry, 0, values, list, std::cref(visit));  // a reference allocates no memory
  }

  /// Counts the instances, and calls `visit` for each instance that exists unless there would be
  /// too many; see Count() and ForEach().
  template <typename Visit>
  void Expand(const spec::Entry& entry, sample::Evaluator& values, sample::StreamId list,
              std::size_t existing, const Visit& visit) {
    if (Count(entry, values, existing)) ForEach(entry, values, list, visit);
  }

 private:
  /// Returns the number of instances of the loops from index `depth` on, including those that `if`
  /// leaves out. Stops counting above `limit`. Returns -1 after adding a finding.
  long CountInstances(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
                      long limit);
  bool Walk(const spec::Entry& entry, std::size_t depth, sample::Evaluator& values,
            sample::StreamId list, const std::function<void()>& visit);

  diag::Findings& findings_;
  long steps_ = 0;  // count of all instances so far, including those that `if` leaves out
};

}  // namespace mjforge::assemble
