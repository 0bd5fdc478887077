// Quoting of names in messages, and the check for duplicate names.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

using expr::IsName;
inline constexpr std::string_view kNameRule =
    "a name is a letter, then letters, digits and underscores";

/// Returns the text in quotes, on one line: control characters become \n or \x07, long texts are
/// cut.
std::string Quoted(std::string_view text);

/// Reports each name that two elements of the same kind have. The names of visual geoms (NAME_vis)
/// are treated as names of parts.
void CheckUniqueNames(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
