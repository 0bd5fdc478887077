#ifndef MJFORGE_OUTPUT_RECORD_FIELDS_H_
#define MJFORGE_OUTPUT_RECORD_FIELDS_H_

// The one table of a record's fields: the writer and the schema follow it.

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <span>
#include <string_view>

#include "mjforge/output/output.h"

namespace mjforge::output {

using JsonWriter = rapidjson::Writer<rapidjson::StringBuffer>;

struct RecordField {
  std::string_view key;
  std::string_view schema;  // members of the field's JSON Schema, on one line
  std::string_view doc;
  void (*write)(JsonWriter&, const Record&);   // the value
  bool (*is_absent)(const Record&) = nullptr;  // left out when it is; null: never
};

/// In the order of a line.
std::span<const RecordField> RecordFields();

}  // namespace mjforge::output

#endif  // MJFORGE_OUTPUT_RECORD_FIELDS_H_
