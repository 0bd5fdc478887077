#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::model {

using expr::IsName;
inline constexpr std::string_view kNameRule =
    "a name is a letter, then letters, digits and underscores";

/// 'text' on one line: control characters as \n or \x07, cut when very long.
std::string Quoted(std::string_view text);

/// Reports names that occur twice among the elements of one kind, including the parts' visual twins
/// (NAME_vis).
void CheckUniqueNames(const Object& object, diag::Findings& findings);

}  // namespace mjforge::model
