// Conversion of texts for the C interface.
#pragma once

#include <string_view>

#include "interface.h"

namespace mjforge::python {

/// Returns a text for C without a copy; the text must live as long as interface.h promises.
inline MjforgeText View(std::string_view text) { return {text.data(), text.size()}; }

}  // namespace mjforge::python
