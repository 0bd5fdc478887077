#pragma once

#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::app {

/// Writes one JSON value for --json; numbers as mjforge spells them.
class Json : public diag::Json {
 public:
  Json() : diag::Json(expr::AppendNumber) {}

  /// A list of objects; `write` writes the members of an item's.
  template <typename List, typename Write>
  void Each(std::string_view key, const List& list, const Write& write) {
    Key(key);
    StartArray();
    for (const auto& item : list) {
      StartObject();
      write(item);
      EndObject();
    }
    EndArray();
  }

  /// All that was written, and a line end.
  std::string Line() { return Take() + "\n"; }
};

}  // namespace mjforge::app
