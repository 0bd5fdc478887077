// Arithmetic of physical dimensions, parsing and formatting of units.
#include "mjforge/expr/dimension.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

// Largest absolute exponent of a base unit, far above the exponents that mechanics needs.
constexpr double kMaxPower = 20;

// Dimensions that have names of their own. Dimension::Text() prefers these names to products of
// base units ("N" to "kg m/s^2").
constexpr std::array<std::pair<Dimension, std::string_view>, 8> kNames = {{
    {{0, 0, 0}, "1"},
    {{0, 0, 0, 1}, "rad"},
    {{1, 1, -2}, "N"},
    {{2, 1, -2}, "Nm"},
    {{0, 1, -2}, "N/m"},
    {{1, 1, -1}, "Ns"},
    {{2, 1, -1}, "Nms"},
    {{0, 1, -1}, "Ns/m"},
}};

// Returns the unit that a single word names: a unit that can follow a number ("mm"), or a name in
// kNames ("Nms"). Returns nullopt for other words.
std::optional<NamedUnit> FindWord(std::string_view word) {
  if (word == "1") return NamedUnit{Dimension::Count()};
  for (const auto& [dimension, name] : kNames) {
    if (name == word) return NamedUnit{dimension};
  }
  const Unit* unit = FindUnitSuffix(word);
  if (unit == nullptr) return std::nullopt;
  return NamedUnit{unit->dimension, unit->numerator == unit->denominator};
}

void AddFactor(std::string& text, std::string_view name, int power) {
  if (power == 0) return;
  if (!text.empty() && !text.ends_with('/')) text += ' ';
  text += name;
  if (power != 1) text += fmt::format("^{}", power);
}

}  // namespace

Dimension Dimension::Checked(double m, double kg, double s, double rad) {
  for (const double power : {m, kg, s}) {
    if (power != std::round(power) || std::abs(power) > kMaxPower) return {};
  }
  const bool is_angle = m == 0 && kg == 0 && s == 0 && rad == 1;
  return {static_cast<int>(m), static_cast<int>(kg), static_cast<int>(s), is_angle ? 1 : 0};
}

Dimension operator*(const Dimension& a, const Dimension& b) {
  if (!a.is_known_ || !b.is_known_) return {};
  return Dimension::Checked(a.m_ + b.m_, a.kg_ + b.kg_, a.s_ + b.s_, a.rad_ + b.rad_);
}

Dimension operator/(const Dimension& a, const Dimension& b) { return a * Power(b, -1); }

Dimension Power(const Dimension& base, double exponent) {
  if (!base.is_known_) return {};
  // Keeps the unit rad in the powers 1 and -1; other powers of an angle are plain numbers. The
  // power -1 is needed because a quotient is computed as a * b^-1, and rad / rad must be a plain
  // number.
  Dimension power =
      Dimension::Checked(base.m_ * exponent, base.kg_ * exponent, base.s_ * exponent, 0);
  if (power == Dimension::Count() && (exponent == 1 || exponent == -1))
    power.rad_ = Dimension::Small(base.rad_ * static_cast<int>(exponent));
  return power;
}

std::string Dimension::Text() const {
  if (is_plain()) return "1";
  for (const auto& [dimension, name] : kNames) {
    if (dimension == *this) return std::string(name);
  }
  const std::array<std::pair<std::string_view, int>, 3> factors = {
      {{"kg", kg_}, {"m", m_}, {"s", s_}}};
  std::string text;
  for (const auto& [name, power] : factors) AddFactor(text, name, std::max(power, 0));
  if (text.empty()) text = "1";
  for (const auto& [name, power] : factors) {
    if (power >= 0) continue;
    text += '/';
    AddFactor(text, name, -power);
  }
  return text;
}

std::optional<Dimension> CommonDimension(const Dimension& a, const Dimension& b) {
  if (a == b) return a;
  if (a.is_plain() && b.is_plain()) return Dimension();
  if (a.is_plain()) return b;
  if (b.is_plain()) return a;
  return std::nullopt;
}

Dimension DimensionAt(const Dimensions& dimensions, std::size_t component) {
  if (dimensions.size() == 1) return dimensions.front();
  return component < dimensions.size() ? dimensions[component] : Dimension();
}

std::optional<NamedUnit> FindUnit(std::string_view text) {
  NamedUnit unit{Dimension::Count()};
  double sign = 1;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" */^"), text.size());
    const std::optional<NamedUnit> word = FindWord(text.substr(0, end));
    if (!word) return std::nullopt;
    text.remove_prefix(end);
    int power = 1;
    if (text.starts_with('^')) {
      const auto [stop, error] = std::from_chars(text.data() + 1, text.data() + text.size(), power);
      if (error != std::errc()) return std::nullopt;
      text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    }
    unit.dimension = unit.dimension * Power(word->dimension, sign * power);
    unit.is_si &= word->is_si;
    if (text.empty()) return unit;
    if (text.find_first_of(" */") != 0) return std::nullopt;
    sign = text.front() == '/' ? -1 : 1;
    text.remove_prefix(1);
  }
  return std::nullopt;
}

}  // namespace mjforge::expr
