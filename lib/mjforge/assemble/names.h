// Names of elements: quoting in messages, and the test for duplicates.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

using expr::IsName;
inline constexpr std::string_view kNameRule =
    "a name is a letter, then letters, digits and underscores";

/// Returns the text in quotes, on one line: control characters as \n or \x07, long texts cut off.
std::string Quoted(std::string_view text);

/// Reports each name that two elements of the same kind share. The names that visual geoms get
/// (NAME_vis) count as names of parts.
void CheckUniqueNames(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
