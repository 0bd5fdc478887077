// Writing of the comment at the beginning of a generated file.
#pragma once

#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

/// Appends the opening comment, without a newline, to the document's text.
void AppendProvenance(const Provenance& provenance, MjcfDocument& document);

}  // namespace mjforge::mjcf
