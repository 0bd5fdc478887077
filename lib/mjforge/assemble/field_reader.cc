// FieldReader: evaluates the fields of an element, and reports values that are not allowed.

#include "mjforge/assemble/field_reader.h"

#include <cmath>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Returns the value whose mark (position in the spec) is used for a finding about the number at
// index `position`: the item if `value` is a list, otherwise `value` itself.
const spec::Value& ItemOf(const spec::Value& value, std::size_t position) {
  const auto* list = std::get_if<spec::List>(&value.form);
  return list != nullptr && position < list->items.size() ? list->items[position] : value;
}

}  // namespace

std::string FieldReader::Owner() const {
  if (name_.empty()) return std::string(element_);
  return fmt::format("{} {}", element_, Quoted(name_));
}

bool FieldReader::Report(Code code, const spec::Field& field, std::string_view what,
                         std::string hint) {
  findings_.Add(code, field.value.mark, fmt::format("{} of {} {}", field.info->key, Owner(), what),
                std::move(hint));
  return false;
}

bool FieldReader::ReportElement(Code code, diag::SourceMark mark, std::string_view what,
                                std::string hint) {
  findings_.Add(code, mark, fmt::format("{} {}", Owner(), what), std::move(hint));
  return false;
}

// Ignores numbers that are not finite, because they were already reported when they were computed.
void FieldReader::ReportNumber(const spec::Field& field, double number, std::size_t position,
                               std::size_t count) {
  if (!std::isfinite(number)) return;
  const spec::Value& item = ItemOf(field.value, position);
  std::string hint;
  if (const auto* expression = std::get_if<expr::Expression>(&item.form)) {
    hint = fmt::format("it is the value of '{}'", expression->text());
  }
  const std::string which = count > 1 ? fmt::format(" {}", position + 1) : std::string();
  findings_.Add(Code::kModelBadValue, item.mark,
                fmt::format("{}{} of {} is {}; it {}", field.info->key, which, Owner(),
                            expr::NumberText(number), spec::Rule(*field.info, number)),
                std::move(hint));
}

std::optional<double> FieldReader::Number(const spec::Field& field) {
  if (field.constant) return field.constant->numbers.front();
  const double number = values_.Number(field.value, PathOf(field));
  if (spec::Holds(*field.info, number)) return number;
  ReportNumber(field, number, 0, 1);
  return std::nullopt;
}

bool FieldReader::Numbers(const spec::Field& field, sample::Numbers& out) {
  if (field.constant) {
    out.assign(field.constant->numbers.begin(), field.constant->numbers.end());
    return true;
  }
  values_.Vector(field.value, PathOf(field), out);
  bool good = true;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (spec::Holds(*field.info, out[i])) continue;
    ReportNumber(field, out[i], i, out.size());
    good = false;
  }
  const auto& [lo, hi] = std::pair(field.info->min_count, field.info->max_count);
  const int count = static_cast<int>(out.size());
  if (good && (count < lo || count > hi)) {
    const std::string wanted = lo == hi ? fmt::format("{}", lo) : fmt::format("{} to {}", lo, hi);
    return Report(Code::kModelBadValue, field,
                  fmt::format("has {}; it must have {}", diag::Counted(count, "number"), wanted));
  }
  return good;
}

bool FieldReader::HasCount(const spec::Field& field, const sample::Numbers& numbers,
                           std::size_t count) {
  if (numbers.size() == count) return true;
  return Report(
      Code::kModelBadValue, field,
      fmt::format("has {}; it must have {}", diag::Counted(numbers.size(), "number"), count));
}

std::optional<sample::PointList> FieldReader::Points(const spec::Field& field) {
  return values_.Points(field.value, PathOf(field));
}

std::optional<std::vector<sample::HoleOutline>> FieldReader::Outlines(const spec::Field& field) {
  return values_.Outlines(field.value, PathOf(field));
}

std::optional<std::string> FieldReader::Text(const spec::Field& field) {
  if (field.constant) return field.constant->text;
  return values_.Text(field.value, PathOf(field));
}

std::optional<std::string> FieldReader::Word(const spec::Field& field) {
  std::optional<std::string> word = Text(field);
  if (!word || field.constant) return word;
  if (expr::HasWord(field.info->words, *word)) return word;
  const std::vector<std::string_view> known = expr::WordsOf(field.info->words);
  Report(Code::kModelBadValue, field,
         fmt::format("is {}; it must be one of {}", Quoted(*word), fmt::join(known, ", ")),
         diag::DidYouMean(*word, known));
  return std::nullopt;
}

std::optional<bool> FieldReader::Boolean(const spec::Field& field) {
  if (field.constant) return field.constant->numbers.front() != 0;
  return values_.Boolean(field.value, PathOf(field));
}

bool FieldReader::ReadAttribute(const spec::Field& field, model::Attribute& out) {
  out.name = field.info->key;
  out.applies = field.info->applies;
  out.refers = field.info->refers;
  const spec::FieldKind kind = field.info->kind;
  const bool has_numbers = kind == spec::FieldKind::kNumber || kind == spec::FieldKind::kInteger ||
                           kind == spec::FieldKind::kNumbers;
  if (has_numbers) {
    if (!field.constant) return Numbers(field, out.numbers.Change());
    out.numbers = model::AttributeNumbers(field.constant);
    return true;
  }
  if (kind == spec::FieldKind::kBoolean) {
    const std::optional<bool> value = Boolean(field);
    if (value) out.text = *value ? "true" : "false";
    return value.has_value();
  }
  std::optional<std::string> text = field.info->words.empty() ? Text(field) : Word(field);
  if (text) out.text = std::move(*text);
  return text.has_value();
}

}  // namespace mjforge::assemble
