// Texts that the C interface returns.
#pragma once

#include <string_view>

#include "interface.h"

namespace mjforge::python {

/// Returns a text, which must live as long as the interface promises.
inline MjforgeText View(std::string_view text) { return {text.data(), text.size()}; }

}  // namespace mjforge::python
