#ifndef MJFORGE_MANIFEST_RECORD_FIELDS_H_
#define MJFORGE_MANIFEST_RECORD_FIELDS_H_

// The one table of a record's fields: the writer and the schema follow it.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

/// Appends JSON to a text, as it comes: a record is a fifth of what a variant costs, and half
/// of that was a general writer's bookkeeping. Objects and lists must be ended in order.
class JsonText {
 public:
  explicit JsonText(std::string& out) : out_(out) {}

  void StartObject() { Open('{'); }
  void EndObject() { out_ += '}'; }
  void StartArray() { Open('['); }
  void EndArray() { out_ += ']'; }
  void Key(std::string_view key) {
    String(key);
    out_ += ':';
  }
  void String(std::string_view text);
  void Raw(std::string_view json) {
    Separate();
    out_ += json;
  }
  void Null() { Raw("null"); }
  void Bool(bool flag) { Raw(flag ? "true" : "false"); }
  void Whole(std::uint64_t number);
  /// To the last bit; null if it is not finite, as JSON has no other word for it.
  void Number(double number);

 private:
  void Open(char bracket) {
    Separate();
    out_ += bracket;
  }
  // Values and members are what follows neither an opening nor a key.
  void Separate() {
    const char last = out_.empty() ? '\n' : out_.back();
    if (last != '{' && last != '[' && last != ':' && last != '\n') out_ += ',';
  }

  std::string& out_;
};

struct RecordField {
  std::string_view key;
  std::string_view schema;  // members of the field's JSON Schema, on one line
  std::string_view doc;
  void (*write)(JsonText&, const Record&);     // the value
  bool (*is_absent)(const Record&) = nullptr;  // left out where this says so
};

/// In the order of a line.
std::span<const RecordField> RecordFields();

}  // namespace mjforge::manifest

#endif  // MJFORGE_MANIFEST_RECORD_FIELDS_H_
