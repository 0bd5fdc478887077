#include "mjforge/attach/attributes.h"

#include <algorithm>
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

void Attributes::Read(const mjModel& m, std::span<const compiled::ArrayField> fields, int id) {
  for (const compiled::ArrayField& field : fields) {
    const sample::Numbers numbers = compiled::NumbersOf(m, field, id);
    if (numbers.empty()) continue;
    const bool usual = field.variable == nullptr && field.usual &&
                       std::equal(numbers.begin(), numbers.end(), field.usual->begin());
    if (usual) continue;
    if (field.IsFlag()) {
      Flag(field.attribute, numbers[0] != 0);
    } else {
      Numbers(field.attribute, std::span(numbers.data(), numbers.size()));
    }
  }
}

void Attributes::Text(std::string_view key, std::string text) { Add(key).text = std::move(text); }

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
