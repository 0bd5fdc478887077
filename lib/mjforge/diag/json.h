#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace mjforge::diag {

/// Readers of JSON that call themselves for each value within another refuse what is nested deeper.
inline constexpr int kMaxJsonDepth = 64;
bool IsNestedTooDeep(std::string_view json);

/// Appends JSON to a text without checking its structure: writing a record took a fifth of a
/// variant's time, and half of that was a general writer's bookkeeping. Objects and lists must be
/// ended in order, texts be valid UTF-8.
class Json {
 public:
  /// How a finite number is spelled: expr::AppendNumber or expr::AppendExactNumber.
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
  /// What is JSON already.
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
  /// null if it is not finite, as JSON has no other word for it.
  void Value(double number) {
    if (!std::isfinite(number)) return Value(nullptr);
    Separate();
    spelling_(text_, number);
  }
  template <typename... Types>
  void Value(const std::variant<Types...>& value) {
    std::visit([this](const auto& held) { Value(held); }, value);
  }
  /// A list of numbers or texts.
  template <typename List>
  requires requires(const List& list) { list.begin(); }
  void Value(const List& list) {
    StartArray();
    for (const auto& item : list) Value(item);
    EndArray();
  }
  template <typename T>
  void Member(std::string_view key, const T& value) {
    Key(key);
    Value(value);
  }

  /// All that was written.
  std::string Take() { return std::move(text_); }

 private:
  void Escaped(std::string_view text);
  void Open(char bracket) {
    Separate();
    text_ += bracket;
  }
  // A comma precedes every value and member except after an opening bracket or a key.
  void Separate() {
    const char last = text_.empty() ? '\n' : text_.back();
    if (last != '{' && last != '[' && last != ':' && last != '\n') text_ += ',';
  }

  NumberFormat spelling_;
  std::string text_;
};

}  // namespace mjforge::diag
