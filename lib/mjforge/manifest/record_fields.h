#ifndef MJFORGE_MANIFEST_RECORD_FIELDS_H_
#define MJFORGE_MANIFEST_RECORD_FIELDS_H_

// The one table of a record's fields: the writer and the schema follow it.

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <span>
#include <string_view>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

using JsonWriter = rapidjson::Writer<rapidjson::StringBuffer>;

struct RecordField {
  std::string_view key;
  std::string_view schema;  // members of the field's JSON Schema, on one line
  std::string_view doc;
  void (*write)(JsonWriter&, const Record&);  // the value
  bool (*is_absent)(const Record&) = nullptr;  // left out where this says so
};

/// In the order of a line.
std::span<const RecordField> RecordFields();

}  // namespace mjforge::manifest

#endif  // MJFORGE_MANIFEST_RECORD_FIELDS_H_
