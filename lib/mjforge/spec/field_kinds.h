#pragma once

#include <string_view>

#include "mjforge/spec/fields.h"

namespace mjforge::spec {

/// What the reference, the schema and messages say about a slot; empty if it depends on the field's
/// counts, bounds or words.
struct FieldKindInfo {
  FieldKind kind;
  std::string_view takes;              // "list of parts"
  std::string_view schema = {};        // members of its JSON Schema, with markers (schema.cc)
  std::string_view drawn = "a value";  // what a draw must give
};

const FieldKindInfo& InfoOf(FieldKind kind);

}  // namespace mjforge::spec
