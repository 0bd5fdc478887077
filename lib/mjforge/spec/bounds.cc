// Computation of bounds from literals, constant expressions and distributions.

#include "mjforge/spec/bounds.h"

#include <algorithm>
#include <limits>

#include "mjforge/spec/values.h"

namespace mjforge::spec {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// Returns the interval from `low` to `high`; nullopt unless both values are constants.
std::optional<Bounds> Between(const Value& low, const Value& high) {
  const auto from = ConstantOf(low);
  const auto to = ConstantOf(high);
  if (!from || !to) return std::nullopt;
  return Bounds{*from, *to};
}

// Returns the smallest interval that contains the bounds of all options of a choice. Returns
// nullopt if an option has no bounds.
std::optional<Bounds> Around(const std::vector<Value>& options) {
  std::optional<Bounds> all;
  for (const Value& option : options) {
    const std::optional<Bounds> bounds = BoundsOf(option);
    if (!bounds) return std::nullopt;
    if (!all) all = bounds;
    all->low = std::min(all->low, bounds->low);
    all->high = std::max(all->high, bounds->high);
  }
  return all;
}

std::optional<Bounds> BoundsOf(const Draw& draw) {
  if (draw.limits.size() == 2) return Between(draw.limits[0], draw.limits[1]);
  switch (draw.distribution) {
    case Distribution::kUniform:
    case Distribution::kLogUniform:
    case Distribution::kTriangular:
    case Distribution::kInteger:
      return Between(draw.arguments.front(), draw.arguments.back());
    case Distribution::kNormal:
      return Bounds{-kUnbounded, kUnbounded};
    case Distribution::kLogNormal:
    case Distribution::kExponential:
    case Distribution::kPoisson:
      return Bounds{0, kUnbounded};
    case Distribution::kBeta:
      return Bounds{0, 1};
    case Distribution::kChoice:
    case Distribution::kCycle:
      return Around(draw.arguments);
    case Distribution::kBernoulli:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Bounds> BoundsOf(const Value& value) {
  if (value.type != expr::Type::kNumber || value.is_list) return std::nullopt;
  if (const auto* draw = std::get_if<Draw>(&value.form)) return BoundsOf(*draw);
  const std::optional<double> number = ConstantOf(value);
  if (!number) return std::nullopt;
  return Bounds{*number, *number};
}

std::vector<Bounds> BoundsOfComponents(const Value& value) {
  std::vector<Bounds> all;
  const auto* list = std::get_if<List>(&value.form);
  if (list == nullptr || value.is_list) return {};
  for (const Value& item : list->items) {
    const std::optional<Bounds> bounds = BoundsOf(item);
    if (!bounds) return {};
    all.push_back(*bounds);
  }
  return all;
}

}  // namespace mjforge::spec
