#pragma once

// The one table of a record's fields: writer, reader, schema and comparison follow it.

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
  void (*write)(diag::Json&, const Record&);  // the value
  /// What the value must be, "a text"; empty: it is, and the record has it now.
  std::string_view (*read)(const rapidjson::Value&, Record&);
  bool (*is_absent)(const Record&) = nullptr;            // left out where this says so
  bool (*same)(const Record&, const Record&) = nullptr;  // null: may differ within a batch
};

/// In the order of a line.
std::span<const RecordField> RecordFields();

}  // namespace mjforge::manifest
