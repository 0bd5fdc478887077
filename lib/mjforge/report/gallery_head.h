// Head of the HTML pages of a gallery: style, script, and the Content Security Policy that allows
// only this style and this script.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/report/templates.h"

namespace mjforge::report {

/// Fills in VERSION, CSS, JS and POLICY.
void AddHead(Dictionary& page);

/// Returns a relative path as a URL, in which all characters except letters, digits and "/._~-" are
/// percent-encoded.
std::string UrlOf(std::string_view path);

}  // namespace mjforge::report
