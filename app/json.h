#ifndef MJFORGE_APP_JSON_H_
#define MJFORGE_APP_JSON_H_

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <Eigen/Dense>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include "mjforge/expr/expr.h"

namespace mjforge::app {

/// Writes one JSON value for --json; numbers as mjforge spells them.
class Json {
 public:
  void StartObject() { writer_.StartObject(); }
  void EndObject() { writer_.EndObject(); }
  void StartArray() { writer_.StartArray(); }
  void EndArray() { writer_.EndArray(); }
  void Key(std::string_view key) { writer_.Key(key.data(), Size(key)); }
  void Raw(std::string_view json) {
    writer_.RawValue(json.data(), json.size(), rapidjson::kObjectType);
  }

  void Value(std::string_view text) { writer_.String(text.data(), Size(text)); }
  void Value(const std::string& text) { Value(std::string_view(text)); }
  void Value(const char* text) { Value(std::string_view(text)); }
  void Value(bool flag) { writer_.Bool(flag); }
  void Value(double number) {
    if (!std::isfinite(number)) {
      writer_.Null();  // JSON has no other word for it
      return;
    }
    const std::string text = expr::NumberText(number);
    writer_.RawValue(text.data(), text.size(), rapidjson::kNumberType);
  }
  void Value(std::unsigned_integral auto number) { writer_.Uint64(number); }
  template <typename Derived>
  void Value(const Eigen::MatrixBase<Derived>& vector) {
    writer_.StartArray();
    for (Eigen::Index i = 0; i < vector.size(); ++i) Value(vector(i));
    writer_.EndArray();
  }
  template <typename T>
  void Member(std::string_view key, const T& value) {
    Key(key);
    Value(value);
  }

  /// All that was written, and a line end.
  std::string Line() const { return std::string(buffer_.GetString(), buffer_.GetSize()) + "\n"; }

 private:
  static rapidjson::SizeType Size(std::string_view text) {
    return static_cast<rapidjson::SizeType>(text.size());
  }

  rapidjson::StringBuffer buffer_;
  rapidjson::Writer<rapidjson::StringBuffer> writer_{buffer_};
};

}  // namespace mjforge::app

#endif  // MJFORGE_APP_JSON_H_
