#pragma once

#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// What an earlier release asks of every file, and later ones do not: that limits are said, states
/// come last, and ranges that must be there stand in the element itself. True if the tree is
/// another one now.
bool KeepOlderRules(XmlElement& root, int version);

}  // namespace mjforge::engine
