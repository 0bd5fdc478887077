// Attributes and values that MuJoCo 2.2.2 reads and later releases, up to 4.0.1, reject.
//
// The facts come from experiments: every element and attribute that a spec passes through, with
// values of each kind, loaded in MuJoCo 2.2.2 and in later releases.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjforge::backport {

/// Returns the reason why releases after `version` reject an attribute with this value, as the part
/// of a warning that follows the name of the element: "has 'znear=0'; MuJoCo 2.3.0 and later
/// require
/// ...". Returns nullopt if they accept it. `parent` is the tag of the parent element.
std::optional<std::string> FindRefusal(std::string_view parent, std::string_view tag,
                                       std::string_view attribute, std::string_view value,
                                       int version);

}  // namespace mjforge::backport
