// Queries about values: constants, literal texts, draws, kinds, validity for a field.

#include "mjforge/spec/values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mjforge::spec {
namespace {

// Returns true for the integers within the bounds of `condim` that MuJoCo does not support.
// Contacts have 1, 3, 4 or 6 dimensions.
bool IsInvalidCondim(const FieldInfo& field, double number) {
  return field.key == "condim" && (number == 2 || number == 5);
}

template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace

bool HasDraw(const Value& value) {
  const auto has_draws = [](const auto& items) { return std::ranges::any_of(items, HasDraw); };
  const Overloaded has_draw = {
      [](double) { return false; },
      [](bool) { return false; },
      [](const expr::Expression&) { return false; },
      [](const VariableReference&) { return false; },
      [](const Text&) { return false; },
      [&](const List& list) { return has_draws(list.items); },
      [&](const HsvColor& color) { return has_draws(color.items); },
      [](const Each& each) { return HasDraw(*each.value) || HasDraw(*each.count); },
      [](const PointLoop& points) {
        return std::ranges::any_of(*points.loops, HasDraw, &Loop::range) || HasDraw(*points.at);
      },
      [](const AxisOutlines& along) { return HasDraw(*along.outlines); },
      [&](const Arc& arc) {
        return has_draws(arc.measures) || HasDraw(*arc.center) || HasDraw(*arc.steps);
      },
      [](const auto&) { return true; }};  // all other forms are draws or imported parameters
  return std::visit(has_draw, value.form);
}

bool IsListLength(double number) {
  return number >= 0 && number <= 100'000 && number == std::floor(number);
}

bool IsSameKind(const Value& a, const Value& b) {
  return a.type == b.type && a.components == b.components && a.is_list == b.is_list;
}

void DeclareIndex(expr::SymbolTable& names) {
  names.Declare("index", expr::Type::kNumber, 1, {expr::Dimension::Count()});
}

const expr::SymbolTable::Variable& Declare(expr::SymbolTable& names, const std::string& name,
                                           const Value& value) {
  return value.is_list ? names.DeclareList(name, value.type, value.dimensions)
                       : names.Declare(name, value.type, std::clamp(value.components, 1, 4),
                                       value.dimensions);
}

std::optional<double> ConstantOf(const Value& value) {
  if (const auto* literal = std::get_if<double>(&value.form)) return *literal;
  const auto* expression = std::get_if<expr::Expression>(&value.form);
  const bool is_number = expression != nullptr && expression->type() == expr::Type::kNumber;
  return is_number ? expression->constant() : std::nullopt;
}

std::optional<std::string_view> LiteralText(const Value& value) {
  const auto* text = std::get_if<Text>(&value.form);
  if (text == nullptr) return std::nullopt;
  if (text->pieces.empty()) return std::string_view();
  const TextPiece& piece = text->pieces.front();
  if (text->pieces.size() > 1 || piece.expression || piece.variable) return std::nullopt;
  return piece.literal;
}

std::string KindText(expr::Type type, std::size_t components) {
  if (type == expr::Type::kText) return "text";
  if (type == expr::Type::kBoolean) return "true or false";
  return components == 1 ? "a number" : fmt::format("{} numbers", components);
}

std::string KindText(const Value& value) {
  if (value.is_list) return fmt::format("a list of {}s", expr::TypeName(value.type));
  return KindText(value.type, static_cast<std::size_t>(value.components));
}

bool Holds(const FieldInfo& field, double number) {
  return std::isfinite(number) && (field.above ? number > field.lower : number >= field.lower) &&
         number <= field.upper &&
         (field.kind != FieldKind::kInteger ||
          (number == std::floor(number) && !IsInvalidCondim(field, number)));
}

std::string Rule(const FieldInfo& field, double number) {
  const auto rule = [](std::string_view what, double bound) {
    return fmt::format("must be {} {}", what, expr::NumberText(bound));
  };
  if (field.above && number <= field.lower) return rule("greater than", field.lower);
  if (number < field.lower) return rule("at least", field.lower);
  if (number > field.upper) return rule("at most", field.upper);
  return IsInvalidCondim(field, number) ? "must be 1, 3, 4 or 6" : "must be a whole number";
}

}  // namespace mjforge::spec
