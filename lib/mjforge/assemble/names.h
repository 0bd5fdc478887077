// Quoting of names in messages, and the check for duplicate names.

#pragma once

#include <span>
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

/// Returns the hint for a name that the object does not have: its body, or the body whose element
/// it is, was left out (`fewer: true`), or one of the names `known` is similar. `full_name` has all
/// prefixes, `shown` is the name as the spec writes it.
std::string MissingNameHint(const model::Object& object, std::string_view full_name,
                            std::string_view shown, std::span<const std::string_view> known);

/// Reports that two elements of a kind ("part") have the same name. Without a hint, an entry with
/// `for` that repeats its own name gets one.
void ReportRepeatedName(std::string_view kind, const std::string& name, diag::SourceMark second,
                        diag::SourceMark first, std::string hint, diag::Findings& findings);

/// Reports each name that two elements of the same kind have. The names of visual geoms (NAME_vis)
/// are treated as names of parts.
void CheckUniqueNames(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
