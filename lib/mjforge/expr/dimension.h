// Physical dimensions (length, mass, time, angle) and the names of their units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::expr {

/// Dimension of a number: a product of powers of m, kg and s, or rad. A plain number (3, a count,
/// the ratio of two lengths) is compatible with every dimension. The dimension of a literal that is
/// not obviously a count is unknown (700 may mean 700 kg/m^3), and so are the dimensions of its
/// products.
class Dimension {
 public:
  constexpr Dimension() = default;  // unknown
  constexpr Dimension(int m, int kg, int s, int rad = 0)
      : m_(Small(m)), kg_(Small(kg)), s_(Small(s)), rad_(Small(rad)), is_known_(true) {}
  /// The dimension of a count or a ratio.
  static constexpr Dimension Count() { return {0, 0, 0}; }
  static constexpr Dimension Angle() { return {0, 0, 0, 1}; }

  bool is_known() const { return is_known_; }
  bool is_plain() const { return !is_known_ || *this == Count(); }
  /// Returns the unit: "m", "kg/m^3", "N"; "1" for a plain number or an unknown dimension.
  std::string Text() const;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
  friend constexpr auto operator<=>(const Dimension&, const Dimension&) = default;
  /// Product and quotient of two dimensions. Angles are factors without dimension: N m/rad times
  /// rad is N m.
  friend Dimension operator*(const Dimension& a, const Dimension& b);
  friend Dimension operator/(const Dimension& a, const Dimension& b);
  /// Returns the dimension of a power; an unknown dimension if a resulting exponent of m, kg or s
  /// is not a whole number, or is larger than any exponent in mechanics.
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

/// Returns the common dimension of two operands that are added or compared. A plain number and a
/// number of unknown dimension take the dimension of the other operand. Returns nullopt if the
/// dimensions differ.
std::optional<Dimension> CommonDimension(const Dimension& a, const Dimension& b);

/// Dimensions of the components of a vector, in order. A single item applies to all components; an
/// empty list means that the dimensions are unknown.
using Dimensions = std::vector<Dimension>;
Dimension DimensionAt(const Dimensions& dimensions, std::size_t component);

/// A unit as written in a spec or in the table of fields: "m", "kg/m^3", "Nm s/rad", "1".
struct NamedUnit {
  Dimension dimension;
  bool is_si = true;  // false for units with another factor, such as "mm"
};
/// Returns the unit that the text represents; nullopt if the text is not a unit.
std::optional<NamedUnit> FindUnit(std::string_view text);

}  // namespace mjforge::expr
