// Fixtures: objects assembled from YAML texts, before and after their start becomes their zero.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::start {

/// Assembles a spec without errors. The header (`mjforge: 1`, `name: thing`) is put before `body`,
/// so that the first line of `body` is line 3.
model::Object Assembled(const std::string& body);
/// Returns the same object with its start as zero configuration.
model::Object Started(const std::string& body);

/// Returns each obstacle as "line: reason (remedy)".
std::vector<std::string> Obstacles(const std::string& body);

/// Returns the numbers of an attribute of the element with this name in a section.
std::vector<double> NumbersIn(const model::Object& object, std::string_view section,
                              const std::string& element, std::string_view attribute);

}  // namespace mjforge::start
