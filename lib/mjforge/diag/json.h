// A writer of compact JSON, and a check of the nesting depth of JSON.

#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace mjforge::diag {

/// Maximum nesting depth of objects and lists in JSON that is parsed by recursive functions.
inline constexpr int kMaxJsonDepth = 64;
/// Returns true if objects and lists are nested deeper than kMaxJsonDepth.
bool IsNestedTooDeep(std::string_view json);

/// Appends JSON to a text. The caller must end objects and lists in the right order, and must pass
/// valid UTF-8. Does not check the structure, because a general JSON writer that checks it took 10
/// % of the time to generate a variant.
class Json {
 public:
  /// A function that appends a finite number to a text: expr::AppendNumber or
  /// expr::AppendExactNumber.
  using NumberFormat = void (*)(std::string&, double);
  explicit Json(NumberFormat spelling, std::string text = {})
      : spelling_(spelling), text_(std::move(text)) {}

  void StartObject() { Open('{'); }
  void EndObject() { text_ += '}'; }
  void StartArray() { Open('['); }
  void EndArray() { text_ += ']'; }
  void Key(std::string_view key) {
    Value(key);
    text_ += ':';
  }
  /// Adds a value that already is JSON text.
  void Raw(std::string_view json) {
    Separate();
    text_ += json;
  }

  void Value(std::string_view text);
  void Value(const std::string& text) { Value(std::string_view(text)); }
  void Value(const char* text) { Value(std::string_view(text)); }
  void Value(bool flag) { Raw(flag ? "true" : "false"); }
  void Value(std::nullptr_t) { Raw("null"); }
  void Value(std::integral auto number) { Raw(std::to_string(number)); }
  /// Adds a number. Adds null if the number is not finite, because JSON cannot represent such a
  /// number.
  void Value(double number) {
    if (!std::isfinite(number)) return Value(nullptr);
    Separate();
    spelling_(text_, number);
  }
  template <typename... Types>
  void Value(const std::variant<Types...>& value) {
    std::visit([this](const auto& held) { Value(held); }, value);
  }
  /// Adds a list of numbers or texts.
  template <typename Items>
  requires requires(const Items& items) { items.begin(); }
  void Value(const Items& items) {
    List(items, [this](const auto& item) { this->Value(item); });
  }
  template <typename T>
  void Member(std::string_view key, const T& value) {
    Key(key);
    Value(value);
  }

  /// Adds an object; `write` adds its members.
  template <typename Write>
  void Object(const Write& write) {
    StartObject();
    write();
    EndObject();
  }
  template <typename Write>
  void Object(std::string_view key, const Write& write) {
    Key(key);
    Object(write);
  }
  /// Adds members: pairs of a key and a value.
  template <typename Pairs>
  void Members(const Pairs& pairs) {
    for (const auto& [key, value] : pairs) Member(key, value);
  }
  /// Adds a list; `write` adds the value of one item.
  template <typename Items, typename Write>
  void List(const Items& items, const Write& write) {
    StartArray();
    for (const auto& item : items) write(item);
    EndArray();
  }
  template <typename Items, typename Write>
  void List(std::string_view key, const Items& items, const Write& write) {
    Key(key);
    List(items, write);
  }
  /// Adds a list of objects; `write` adds the members of one item's object.
  template <typename Items, typename Write>
  void Each(const Items& items, const Write& write) {
    List(items, [&](const auto& item) { Object([&] { write(item); }); });
  }
  template <typename Items, typename Write>
  void Each(std::string_view key, const Items& items, const Write& write) {
    Key(key);
    Each(items, write);
  }

  /// Returns the text; the writer is empty after this call.
  std::string Take() { return std::move(text_); }

 private:
  void Escaped(std::string_view text);
  void Open(char bracket) {
    Separate();
    text_ += bracket;
  }
  // Adds a comma before a value or a key, except after an opening bracket, after a key and at the
  // start of a line.
  void Separate() {
    const char last = text_.empty() ? '\n' : text_.back();
    if (last != '{' && last != '[' && last != ':' && last != '\n') text_ += ',';
  }

  NumberFormat spelling_;
  std::string text_;
};

/// Returns the text of one JSON object; `write` adds the members to the given Json.
template <typename Write>
std::string JsonObject(Json::NumberFormat spelling, const Write& write) {
  Json json(spelling);
  json.Object([&] { write(json); });
  return json.Take();
}

}  // namespace mjforge::diag
