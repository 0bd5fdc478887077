// JSON results of commands (--json).
#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::app {

/// Writes one JSON value, with numbers in mjforge's format.
class JsonOutput : public diag::Json {
 public:
  JsonOutput() : diag::Json(expr::AppendNumber) {}

  /// Adds a member that is an object; `write` adds its members.
  template <typename Write>
  void Object(std::string_view key, const Write& write) {
    Key(key);
    StartObject();
    write();
    EndObject();
  }

  /// Adds a member that is a list of objects; `write` adds the members of one item's object.
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
};

/// Returns one JSON object and a line end; `write` adds the members of the object.
template <typename Write>
std::string JsonLine(const Write& write) {
  JsonOutput json;
  json.StartObject();
  write(json);
  json.EndObject();
  return json.Take() + "\n";
}

}  // namespace mjforge::app
