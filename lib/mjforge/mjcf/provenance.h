#pragma once

#include <string>

#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

/// Appends the opening comment, without a line end.
void AppendProvenance(const Provenance& provenance, MjcfDocument& document);

}  // namespace mjforge::mjcf
