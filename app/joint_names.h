#pragma once

#include <string>
#include <vector>

namespace mjforge::app {

/// A hinge or slide, for completion.
struct JointName {
  std::string name;
  std::string short_name;  // without the object's prefix, if that is enough
  std::string meaning;     // "hinge, 0 to 1.92 rad"
};

/// Those of the first variant of a spec with these settings (NAME=VALUE), or of an MJCF file. None
/// where anything is wrong.
std::vector<JointName> NamesOfJoints(const std::string& what,
                                     const std::vector<std::string>& settings);

}  // namespace mjforge::app
