// Evaluation of fields whose value is the same in all variants.

#include <algorithm>

#include "mjforge/spec/entry.h"

namespace mjforge::spec {
namespace {

bool AddNumber(const FieldInfo& field, const Value& value, ConstantValue& out) {
  const std::optional<double> number = ConstantOf(value);
  if (!number || !Holds(field, *number)) return false;
  if (!out.numbers.empty()) out.text += ' ';
  expr::AppendNumber(out.text, *number);
  out.numbers.push_back(*number);
  return true;
}

std::optional<ConstantValue> NumbersOf(const FieldInfo& field, const Value& value) {
  ConstantValue out;
  const auto* list = std::get_if<List>(&value.form);
  const auto add = [&](const Value& number) { return AddNumber(field, number, out); };
  if (list != nullptr ? !std::ranges::all_of(list->items, add) : !add(value)) return std::nullopt;
  const int count = static_cast<int>(out.numbers.size());
  if (count < field.min_count || count > field.max_count) return std::nullopt;
  return out;
}

// Returns the value of a field if all variants have this value and the field table allows it.
// Otherwise, and for points, outlines and joint positions, returns nullopt.
std::optional<ConstantValue> ConstantValueOf(const FieldInfo& field, const Value& value) {
  switch (field.kind) {
    case FieldKind::kNumber:
    case FieldKind::kInteger:
    case FieldKind::kNumbers:
      return NumbersOf(field, value);
    case FieldKind::kBoolean:
      if (const bool* is_true = std::get_if<bool>(&value.form))
        return ConstantValue{{*is_true ? 1.0 : 0.0}, *is_true ? "true" : "false"};
      return std::nullopt;
    case FieldKind::kWord:
    case FieldKind::kText: {
      const auto text = LiteralText(value);
      if (!text || (!field.words.empty() && !expr::HasWord(field.words, *text)))
        return std::nullopt;
      return ConstantValue{{}, std::string(*text)};
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

Field::Field(const FieldInfo* field, Value content, diag::SourceMark key)
    : info(field), value(std::move(content)), mark(key) {
  if (auto found = ConstantValueOf(*field, value))
    constant = std::make_shared<const ConstantValue>(*std::move(found));
}

}  // namespace mjforge::spec
