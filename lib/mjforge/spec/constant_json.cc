// Conversion of values that are the same in all variants to JSON text.

#include "mjforge/spec/constant_json.h"

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {
namespace {

bool WriteConstants(diag::Json& json, const std::vector<Value>& values);

// Writes a value that is the same in all variants. For any other value, returns false, possibly
// after writing a part of the value.
bool WriteConstant(diag::Json& json, const Value& value) {
  if (const auto number = ConstantOf(value)) {
    json.Value(*number);
  } else if (const auto text = LiteralText(value)) {
    json.Value(*text);
  } else if (const auto* flag = std::get_if<bool>(&value.form)) {
    json.Value(*flag);
  } else {
    const auto* list = std::get_if<List>(&value.form);
    return list != nullptr && WriteConstants(json, list->items);
  }
  return true;
}

bool WriteConstants(diag::Json& json, const std::vector<Value>& values) {
  bool is_good = true;
  json.List(values, [&](const Value& value) { is_good = is_good && WriteConstant(json, value); });
  return is_good;
}

}  // namespace

std::optional<std::string> ConstantChoices(const Value& value) {
  const auto* draw = std::get_if<Draw>(&value.form);
  if (draw == nullptr || !draw->is_choice()) return std::nullopt;
  diag::Json choices(expr::AppendExactNumber);
  if (!WriteConstants(choices, draw->arguments)) return std::nullopt;
  return choices.Take();
}

}  // namespace mjforge::spec
