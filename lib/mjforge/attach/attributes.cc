#include "mjforge/attach/attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>

#include "mjforge/expr/expr.h"

namespace mjforge::attach {

model::Attribute& Attributes::Add(std::string_view key) {
  const spec::FieldInfo* field = info_.Find(key);
  if (field == nullptr) throw std::logic_error("no attribute " + std::string(key));
  model::Attribute& attribute = out_.emplace_back();
  attribute.name = field->key;
  attribute.applies = field->applies;
  attribute.refers = field->refers;
  return attribute;
}

void Attributes::Numbers(std::string_view key, std::span<const double> values) {
  sample::Numbers& numbers = Add(key).numbers;
  for (const double value : values) numbers.push_back(value);
}

void Attributes::Numbers(std::string_view key, std::span<const double> values,
                         std::initializer_list<double> usual) {
  if (!std::ranges::equal(values, usual)) Numbers(key, values);
}

void Attributes::Numbers(std::string_view key, std::span<const float> values,
                         std::initializer_list<double> usual) {
  std::vector<double> numbers;
  for (const float value : values) numbers.push_back(Shortest(value));
  Numbers(key, std::span<const double>(numbers), usual);
}

void Attributes::User(std::span<const double> values) {
  while (!values.empty() && values.back() == 0) values = values.first(values.size() - 1);
  if (!values.empty()) Numbers("user", values);
}

void Attributes::Text(std::string_view key, std::string text) { Add(key).text = std::move(text); }

double Shortest(float value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double number = value;
  std::from_chars(text.data(), end, number);
  return number;
}

std::vector<double> ParseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view word : expr::WordsOf(text)) {
    const std::optional<double> number = expr::ParseNumber(word);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace mjforge::attach
