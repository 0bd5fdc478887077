// Names of joints of a spec or an MJCF file, for completion in shells.
#pragma once

#include <string>
#include <vector>

namespace mjforge::app {

/// A hinge or slide.
struct JointName {
  std::string name;
  std::string short_name;  // without the object's prefix if that is unambiguous, else `name`
  std::string meaning;     // "hinge, 0 to 1.92 rad"
};

/// Returns the joints of the first variant of a spec with these settings (NAME=VALUE), or of an
/// MJCF file; empty if there is an error.
std::vector<JointName> NamesOfJoints(const std::string& what,
                                     const std::vector<std::string>& settings);

}  // namespace mjforge::app
