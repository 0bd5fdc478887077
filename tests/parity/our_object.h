#pragma once

#include <string>
#include <vector>

#include "described.h"
#include "mjforge/spec/spec.h"

namespace mjforge::parity {

struct OurObject {
  /// Every finding on the way, as the user would see it; empty if all is well.
  std::string findings;
  Described described;  // from the MJCF and from what MuJoCo compiled of it
};

/// Loads the spec (a name of the catalogue or a path), samples, assembles,
/// writes, validates and compiles it.
OurObject MakeObject(const std::string& spec, const std::string& name,
                     const std::vector<spec::Setting>& settings);

}  // namespace mjforge::parity
