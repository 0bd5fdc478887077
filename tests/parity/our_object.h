// Objects of ours, made from specs and described for comparison.

#pragma once

#include <string>
#include <vector>

#include "described.h"
#include "mjforge/spec/spec.h"

namespace mjforge::parity {

struct OurObject {
  /// All findings of all stages, rendered as for users.
  std::string findings;
  Described described;  // from the MJCF and from MuJoCo's compiled model
};

/// Loads the spec (a name of the catalogue or a path), samples, assembles,
/// writes, validates and compiles it.
OurObject MakeObject(const std::string& spec, const std::string& name,
                     const std::vector<spec::Setting>& settings);

}  // namespace mjforge::parity
