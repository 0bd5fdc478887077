// Descriptions of field kinds for the reference, the JSON Schema and messages.

#pragma once

#include <string_view>

#include "mjforge/spec/fields.h"

namespace mjforge::spec {

/// Description of a field kind. A text is empty if it depends on the counts, bounds or words of the
/// field.
struct FieldKindInfo {
  FieldKind kind;
  std::string_view takes;        // "list of parts"
  std::string_view schema = {};  // members of the kind's JSON Schema, with markers (see schema.cc)
  std::string_view drawn = "a value";  // description of a draw's result that suits the kind
};

const FieldKindInfo& InfoOf(FieldKind kind);

}  // namespace mjforge::spec
