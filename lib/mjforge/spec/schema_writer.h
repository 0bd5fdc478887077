#ifndef MJFORGE_SPEC_SCHEMA_WRITER_H_
#define MJFORGE_SPEC_SCHEMA_WRITER_H_

// The words of JSON Schema, written one after the other.

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include "mjforge/expr/expr.h"

namespace mjforge::spec {

class SchemaWriter {
 protected:
  SchemaWriter() { writer_.SetIndent(' ', 2); }

  using Body = std::function<void()>;

  void Key(std::string_view key) { writer_.Key(key.data(), Size(key)); }
  void String(std::string_view text) { writer_.String(text.data(), Size(text)); }
  void OpenList() { writer_.StartArray(); }
  void CloseList() { writer_.EndArray(); }
  void Object(const Body& body) {
    writer_.StartObject();
    body();
    writer_.EndObject();
  }
  void Text(std::string_view key, std::string_view text) {
    Key(key);
    String(text);
  }
  void Bound(std::string_view key, double value) {
    Key(key);
    const std::string text = expr::NumberText(value);
    writer_.RawValue(text.data(), text.size(), rapidjson::kNumberType);
  }
  void Count(std::string_view key, int count) {
    Key(key);
    writer_.Int(count);
  }
  void NoOtherKeys() {
    Key("additionalProperties");
    writer_.Bool(false);
  }
  void Strings(std::string_view key, std::initializer_list<std::string_view> texts) {
    Key(key);
    OpenList();
    for (const std::string_view text : texts) String(text);
    CloseList();
  }
  void AnyOf(std::initializer_list<Body> bodies) {
    Key("anyOf");
    OpenList();
    for (const Body& body : bodies) Object(body);
    CloseList();
  }
  void Ref(std::string_view definition) {
    Text("$ref", fmt::format("#/definitions/{}", definition));
  }
  std::string Finish() const { return std::string(buffer_.GetString(), buffer_.GetSize()) + "\n"; }

 private:
  static rapidjson::SizeType Size(std::string_view text) {
    return static_cast<rapidjson::SizeType>(text.size());
  }

  rapidjson::StringBuffer buffer_;
  rapidjson::PrettyWriter<rapidjson::StringBuffer> writer_{buffer_};
};

}  // namespace mjforge::spec

#endif  // MJFORGE_SPEC_SCHEMA_WRITER_H_
