// Functions of ValueReader that check bounds and units, and the conversion of units to dimensions.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/spec/value_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using expr::Dimension;
using expr::Dimensions;
using expr::Type;

// Returns the unit of a component. "s, 1" has a unit for each component; a single unit applies to
// all components. A component without a unit is a plain number.
std::string_view UnitAt(std::string_view units, int component) {
  const std::vector<std::string_view> all = Split(units, ", ");
  if (all.size() == 1) return units;
  const auto at = static_cast<std::size_t>(component);
  return at < all.size() ? all[at] : std::string_view();
}

// Returns the unit of a joint's field for the motion of the joint. For the unit "rad or m", returns
// "rad" for kTurn, "m" for kSlide, and the whole text for kAny.
std::string_view UnitOf(Motion motion, std::string_view unit) {
  const std::vector<std::string_view> both = Split(unit, " or ");
  if (motion == Motion::kAny) return unit;
  return motion == Motion::kTurn ? both.front() : both.back();
}

// Unit of directions, which may have any unit, because only the ratios of their numbers matter.
constexpr std::string_view kAnyOne = "any one";

bool Fits(std::string_view unit, const Dimension& dimension) {
  const auto is_of = [&](std::string_view one) {
    const auto named = expr::FindUnit(one);
    return named && named->dimension == dimension;
  };
  return dimension.is_plain() || unit == kAnyOne || std::ranges::any_of(Split(unit, " or "), is_of);
}

// Returns the unit for a message: "in m", "in m or a plain number", "a plain number".
std::string InUnit(std::string_view unit) {
  if (unit.empty() || unit == "1") return "a plain number";
  constexpr std::string_view kOrPlain = " or 1";
  if (!unit.ends_with(kOrPlain)) return fmt::format("in {}", unit);
  unit.remove_suffix(kOrPlain.size());
  return fmt::format("in {} or a plain number", unit);
}

bool Fits(const Dimension& wanted, const Dimension& given) {
  return given.is_plain() || !wanted.is_known() || wanted == given;
}

std::optional<Dimensions> Common(const Dimensions& a, const Dimensions& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Dimensions both(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < both.size(); ++i) {
    const auto one = expr::CommonDimension(DimensionAt(a, i), DimensionAt(b, i));
    if (!one) return std::nullopt;
    both[i] = *one;
  }
  return both;
}

// Returns two units that the numbers of a direction mix ("in m and in kg"); nullopt if the numbers
// of each direction have a common unit. A direction has three numbers.
std::optional<std::string> Clash(const FieldInfo& field, const Value& value) {
  const auto* list = std::get_if<List>(&value.form);
  Dimension common;
  for (int i = 0; i < value.components; ++i) {
    if (UnitAt(field.unit, i) != kAnyOne) continue;
    const auto at = static_cast<std::size_t>(i);
    const Dimension own = list != nullptr ? DimensionAt(list->items[at].dimensions, 0)
                                          : DimensionAt(value.dimensions, at);
    const auto both = i % 3 == 0 ? own : expr::CommonDimension(common, own);
    if (!both) return fmt::format("in {} and in {}", common.Text(), own.Text());
    common = *both;
  }
  return std::nullopt;
}

// Returns a hint if the number would be valid in degrees, otherwise an empty text.
std::string DegreesHint(const FieldInfo& field, double number) {
  const bool is_degrees = field.unit == "rad" && Holds(field, number * std::numbers::pi / 180);
  return is_degrees ? fmt::format("angles are in rad: write {}deg", expr::NumberText(number)) : "";
}

}  // namespace

std::string UnitText(const Dimensions& dimensions) {
  return diag::Joined(dimensions, ", ", &Dimension::Text);
}

bool IsMeasured(const Dimensions& dimensions) {
  return !std::ranges::all_of(dimensions, &Dimension::is_plain);
}

std::optional<Dimensions> DimensionsOf(std::string_view units) {
  Dimensions dimensions;
  for (const std::string_view unit : Split(units, ", ")) {
    const auto named = expr::FindUnit(unit);
    if (!named) return std::nullopt;
    dimensions.push_back(named->dimension);
  }
  return dimensions;
}

void ValueReader::CheckBounds(const FieldInfo& field, const Value& value, int position) {
  if (const auto* list = std::get_if<List>(&value.form);
      list && field.kind == FieldKind::kNumbers) {
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      CheckBounds(field, list->items[i], static_cast<int>(i) + 1);
    }
  } else if (const auto* draw = std::get_if<Draw>(&value.form)) {
    CheckDrawBounds(field, *draw, position);
  } else if (const auto number = ConstantOf(value); number && value.components == 1) {
    const std::string what = position > 0 && field.max_count > 1
                                 ? fmt::format("{} {}", field.key, position)
                                 : std::string(field.key);
    if (!std::isfinite(*number)) {
      findings_.Add(Code::kExprNotFinite, value.mark,
                    fmt::format("{} is not a finite number", what));
    } else if (!Holds(field, *number)) {
      findings_.Add(
          Code::kSpecBadValue, value.mark,
          fmt::format("{} is {}; it {}", what, expr::NumberText(*number), Rule(field, *number)),
          IsMeasured(value.dimensions) ? "" : DegreesHint(field, *number));
    }
  }
}

// Reports options of a choice or cycle, and ends of a uniform range, that are out of bounds,
// because some variant would draw an invalid value.
void ValueReader::CheckDrawBounds(const FieldInfo& field, const Draw& draw, int position) {
  if (draw.is_choice()) {
    for (const Value& option : draw.arguments) CheckBounds(field, option, position);
  } else if (draw.distribution == Distribution::kUniform) {
    // Allows ends of the range that equal an exclusive lower bound of the field.
    FieldInfo ends = field;
    ends.above = false;
    ends.kind = FieldKind::kNumber;
    for (const Value& end : draw.arguments) CheckBounds(ends, end, position);
  }
}

bool ValueReader::CheckUnit(std::string_view what, const Dimensions& wanted, const Value& value) {
  const Dimensions& given = value.dimensions;
  bool fits = true;
  for (std::size_t i = 0; i < std::max(wanted.size(), given.size()); ++i)
    fits &= Fits(DimensionAt(wanted, i), DimensionAt(given, i));
  if (fits) return true;
  findings_.Add(Code::kExprUnits, value.mark,
                fmt::format("{} is {}, but this is {}", what, InUnit(UnitText(wanted)),
                            InUnit(UnitText(given))));
  return false;
}

void ValueReader::CheckUnits(const FieldInfo& field, const Value& value, int position,
                             Motion motion) {
  if (field.any_unit || value.type != Type::kNumber) return;
  const auto* list = std::get_if<List>(&value.form);
  const auto* draw = std::get_if<Draw>(&value.form);
  if (const auto clash = Clash(field, value)) {
    findings_.Add(Code::kExprUnits, value.mark,
                  fmt::format("{} must be in one unit, but is {}", field.key, *clash));
  } else if (list != nullptr) {
    int at = position;
    for (const Value& item : list->items) CheckUnits(field, item, at++, motion);
  } else if (draw != nullptr && draw->is_choice()) {
    for (const Value& option : draw->arguments) CheckUnits(field, option, position, motion);
  } else {
    for (int i = 0; i < value.components; ++i) {
      const std::string_view unit = UnitOf(motion, UnitAt(field.unit, position + i));
      const Dimension dimension = DimensionAt(value.dimensions, static_cast<std::size_t>(i));
      if (Fits(unit, dimension)) continue;
      findings_.Add(
          Code::kExprUnits, value.mark,
          fmt::format("{} is {}, but this is in {}", field.key, InUnit(unit), dimension.Text()));
      return;
    }
  }
}

void ValueReader::CheckPlain(std::string_view what, const Value& value) {
  CheckUnit(what, {Dimension::Count()}, value);
}

Dimensions ValueReader::Agree(std::string_view what, std::span<const Value> values) {
  Dimensions common;
  for (const Value& value : values) {
    const auto both = Common(common, value.dimensions);
    if (!both) {
      findings_.Add(Code::kExprUnits, value.mark,
                    fmt::format("{} must be in one unit, but are in {} and in {}", what,
                                UnitText(common), UnitText(value.dimensions)));
      return {};
    }
    common = *both;
  }
  return common;
}

Dimensions ValueReader::DimensionsOfDraw(const DistributionInfo& info, const FieldInfo& expected,
                                         const Draw& draw) {
  for (const Value& weight : draw.weights) CheckPlain("a weight", weight);
  Dimensions limits = Agree(fmt::format("the numbers of '{}'", info.option), draw.limits);
  switch (info.id) {
    case Distribution::kChoice:
    case Distribution::kCycle:
      // For a field, CheckUnits() compares the unit of each option with the field's unit.
      return expected.key.empty() ? Agree("the values to choose from", draw.arguments)
                                  : Dimensions();
    case Distribution::kUniform:
    case Distribution::kLogUniform:
    case Distribution::kTriangular:
    case Distribution::kNormal: {
      const Dimensions drawn = Agree(fmt::format("the numbers of '{}'", info.key), draw.arguments);
      for (const Value& limit : draw.limits) CheckUnit("what is drawn", drawn, limit);
      return IsMeasured(drawn) ? drawn : limits;
    }
    case Distribution::kLogNormal:
    case Distribution::kExponential:
      return limits;
    case Distribution::kBeta:
    case Distribution::kPoisson:
    case Distribution::kInteger:
    case Distribution::kBernoulli:
      break;
  }
  for (const Value& argument : draw.arguments)
    CheckPlain(fmt::format("what '{}' takes", info.key), argument);
  return info.id == Distribution::kBeta && !limits.empty() ? limits
                                                           : Dimensions{Dimension::Count()};
}

}  // namespace mjforge::spec
