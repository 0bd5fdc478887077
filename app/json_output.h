// JSON results of commands (--json).
#pragma once

#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::app {

/// Returns one JSON object, with numbers in mjforge's format, and a line end; `write` adds the
/// members of the object to the given diag::Json.
template <typename Write>
std::string JsonLine(const Write& write) {
  return diag::JsonObject(expr::AppendNumber, write) + "\n";
}

}  // namespace mjforge::app
