// The head of the pages of a gallery: style, script and the policy that allows only these.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/report/templates.h"

namespace mjforge::report {

/// Fills in VERSION, CSS, JS and POLICY.
void AddHead(Dictionary& page);

/// Returns a relative path as a URL: all but letters, digits and "/._~-" is percent-encoded.
std::string UrlOf(std::string_view path);

}  // namespace mjforge::report
