// Properties that depend on all bodies of a spec: of subtrees, positions of sites, torques of
// joints.

#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/repetition.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Removes the values of `count` variables, starting with the variable at index `slot` of the
/// evaluator. Does nothing if `slot` is negative.
void ClearSlots(int slot, std::size_t count, sample::Evaluator& values);
/// Sets the variables from slot `slot` on to the properties of a body, in the order of
/// spec::BodyProperty. `mass` is in kg.
void SetMeasures(const model::Bounds& bounds, double mass, int slot, sample::Evaluator& values);

/// Sets the variables for the properties of subtrees, sites and joints in one spec, whose bodies
/// are in `object`.
class WholeProperties {
 public:
  WholeProperties(Scope& scope, const model::Object& object, Repetition& repetition,
                  diag::Findings& findings)
      : scope_(scope), object_(object), repetition_(repetition), findings_(findings) {}

  /// Removes the values of all variables, because `if` may leave out bodies, sites and joints.
  void Clear();
  /// Sets NAME.subtree_top and the other properties of subtrees. `bodies` maps full names to
  /// indices.
  void SetSubtrees(const std::unordered_map<std::string, int>& bodies);
  /// Sets NAME.pos of sites, in the frame of the spec. `root` is the index of the body to which the
  /// spec's root elements belong.
  void SetPositions(std::size_t root);
  /// Sets torque(NAME) for the joints of a body; `joints` is the random stream of the joints.
  void SetTorques(const std::vector<spec::Entry>& entries, std::size_t body,
                  sample::StreamId joints);

 private:
  Scope& scope_;
  const model::Object& object_;
  Repetition& repetition_;
  diag::Findings& findings_;
};

/// Returns true if any expression uses a property of one of these joints or sites.
bool AreUsed(const std::vector<spec::Entry>& entries);

}  // namespace mjforge::assemble
