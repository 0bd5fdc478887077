// The table of a record's fields, which writer, reader, schema and comparison use.

#pragma once

#include <span>
#include <string>
#include <string_view>

#include <rapidjson/document.h>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

struct RecordField {
  const char* key;
  std::string schema;  // members of the field's JSON Schema, on one line
  std::string_view doc;
  void (*write)(diag::Json&, const Record&);  // writes the value, without the key
  /// Stores the value in the record and returns an empty text, or returns the kind of value that
  /// was expected: "a text".
  std::string_view (*read)(const rapidjson::Value&, Record&);
  bool (*is_absent)(const Record&) = nullptr;            // true: the field is left out; null: never
  bool (*same)(const Record&, const Record&) = nullptr;  // null: may differ within a batch
};

/// Returns all fields in the order in which a line has them.
std::span<const RecordField> RecordFields();

}  // namespace mjforge::manifest
