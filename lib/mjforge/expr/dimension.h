#pragma once

// What numbers measure: lengths, masses, angles, and their products.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::expr {

/// A product of powers of m, kg and s, or rad. A plain number (3, a count, the ratio of two
/// lengths) fits anything; one that is not known to be a count or a ratio may itself measure
/// something (700 for 700 kg/m^3), so nothing is known of its products.
class Dimension {
 public:
  constexpr Dimension() = default;  // a number that may measure anything
  constexpr Dimension(int m, int kg, int s, int rad = 0)
      : m_(Small(m)), kg_(Small(kg)), s_(Small(s)), rad_(Small(rad)), is_known_(true) {}
  /// A count or a ratio.
  static constexpr Dimension Count() { return {0, 0, 0}; }

  bool is_known() const { return is_known_; }
  bool is_plain() const { return !is_known_ || *this == Count(); }
  /// "m", "kg/m^3", "N"; "1" for a plain number.
  std::string Text() const;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
  friend constexpr auto operator<=>(const Dimension&, const Dimension&) = default;
  /// An angle times or through anything else is only a factor: N m/rad times rad is N m.
  friend Dimension operator*(const Dimension& a, const Dimension& b);
  friend Dimension operator/(const Dimension& a, const Dimension& b);
  /// Unknown where a power would not be a whole number.
  friend Dimension Power(const Dimension& base, double exponent);

 private:
  static constexpr std::int8_t Small(int power) { return static_cast<std::int8_t>(power); }
  static Dimension Checked(double m, double kg, double s, double rad);

  std::int8_t m_ = 0;
  std::int8_t kg_ = 0;
  std::int8_t s_ = 0;
  std::int8_t rad_ = 0;
  bool is_known_ = false;
};

/// What numbers measure that are added or compared; nothing if they measure different things.
std::optional<Dimension> Common(const Dimension& a, const Dimension& b);

/// Of the components of a vector, in order. One is that of all; empty: unknown.
using Dimensions = std::vector<Dimension>;
Dimension DimensionAt(const Dimensions& dimensions, std::size_t component);

/// A unit as specs and tables name it: "m", "kg/m^3", "Nm s/rad", "1".
struct NamedUnit {
  Dimension dimension;
  bool is_si = true;  // false: "mm"
};
/// Nothing if the text names none.
std::optional<NamedUnit> FindUnit(std::string_view text);

}  // namespace mjforge::expr
