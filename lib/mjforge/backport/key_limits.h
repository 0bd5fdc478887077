// Limit of older MuJoCo releases on the number of values in an attribute of a keyframe.
#pragma once

#include <cstddef>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {

/// Largest number of values in an attribute of `<key>` up to MuJoCo 3.2.4; later releases have no
/// limit.
inline constexpr std::size_t kMaxKeyNumbers = 1000;

/// Removes attributes with more than kMaxKeyNumbers numbers from all keys if the release `version`
/// (a mjVERSION_HEADER) has this limit, and returns true if the tree changed. Warns of each removed
/// attribute, unless `findings` is null.
bool RemoveLongKeys(xml::XmlElement& root, int version, const diag::Sources& sources,
                    diag::Findings* findings);

}  // namespace mjforge::backport
