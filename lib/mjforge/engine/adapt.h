#pragma once

// A file written for a later MuJoCo, as an earlier one reads it.

#include "mjforge/diag/diag.h"
#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// The release for which mjforge writes its files.
inline constexpr int kPortable = 222;

enum class Use {
  kWholeModel,
  kBodies,  // settings of the model (`option`, `visual`, ...) are not used
};

/// Changes the tree into what means the same in that release (as mjVERSION_HEADER): limits hold
/// where the file says a range, as since 3.0, and what later releases added is said in other words.
/// What cannot be said, but is only seen or only sets how a model is computed, is left out with a
/// warning; anything else is an error. Each is reported once for each attribute and file, at the
/// first that is lost. True if the tree is another one now.
bool AdaptMjcf(XmlElement& root, int version, Use use, const diag::Sources& sources,
               diag::Findings& findings);

/// The place of an attribute in the text of its element; the element's, if it is not found.
diag::SourceMark MarkOfAttribute(const diag::Sources& sources, const XmlElement& element,
                                 std::string_view attribute);

}  // namespace mjforge::engine
