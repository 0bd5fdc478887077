// Values that are the same in all variants, as JSON.

#include "mjforge/spec/constant_json.h"

#include "mjforge/spec/values.h"

namespace mjforge::spec {

bool WriteConstant(diag::Json& json, const Value& value) {
  if (const auto number = ConstantOf(value)) {
    json.Value(*number);
  } else if (const auto text = LiteralText(value)) {
    json.Value(*text);
  } else if (const auto* flag = std::get_if<bool>(&value.form)) {
    json.Value(*flag);
  } else if (const auto* list = std::get_if<List>(&value.form)) {
    json.StartArray();
    for (const Value& item : list->items) {
      if (!WriteConstant(json, item)) return false;
    }
    json.EndArray();
  } else {
    return false;
  }
  return true;
}

}  // namespace mjforge::spec
