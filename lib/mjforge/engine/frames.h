#pragma once

#include <functional>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/engine/later_mjcf.h"
#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// What adapting a file does with an element that only that release has.
using RefuseLater = std::function<void(const XmlElement&, const Later&)>;

/// Multiplies each `<frame>` (MuJoCo 3.1) into what stands in it and takes it away: poses, axes and
/// directions are those in the body then, and what a class says of a pose stands in the elements.
/// `refuse` is told what a frame holds that has no pose of its own. With global coordinates, which
/// no release has beside frames, it stays. True if the tree is another one now.
bool ComposeFrames(XmlElement& root, const diag::Sources& sources, diag::Findings& findings,
                   const RefuseLater& refuse);

/// Whether an element below has this tag.
bool Contains(const XmlElement& root, std::string_view tag);

}  // namespace mjforge::engine
