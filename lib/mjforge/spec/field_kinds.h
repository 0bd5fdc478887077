// Descriptions of field kinds for the reference, the JSON Schema and messages.

#pragma once

#include <string_view>

#include "mjforge/spec/fields.h"

namespace mjforge::spec {

/// Description of a field kind. `takes` and `schema` are empty if they are made from the field
/// itself or from another table.
struct FieldKindInfo {
  FieldKind kind;
  std::string_view takes;        // "list of parts"
  std::string_view schema = {};  // members of the kind's JSON Schema, with markers (see schema.cc)
  std::string_view drawn = "a value";  // result that a draw for such a field must have
};

const FieldKindInfo& InfoOf(FieldKind kind);

}  // namespace mjforge::spec
