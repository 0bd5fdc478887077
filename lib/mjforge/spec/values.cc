#include "mjforge/spec/values.h"

#include <algorithm>

namespace mjforge::spec {

bool HasDraw(const Value& value) {
  if (const auto* list = std::get_if<List>(&value.form)) {
    return std::ranges::any_of(list->items, HasDraw);
  }
  if (const auto* color = std::get_if<HsvColor>(&value.form)) {
    return std::ranges::any_of(color->items, HasDraw);
  }
  return std::holds_alternative<Draw>(value.form) ||
         std::holds_alternative<RandomRotation>(value.form) ||
         std::holds_alternative<RotationAbout>(value.form) ||
         std::holds_alternative<PointOnSphere>(value.form);
}

}  // namespace mjforge::spec
