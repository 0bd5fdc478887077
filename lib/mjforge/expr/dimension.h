// Physical dimensions (length, mass, time, angle) and the names of their units.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::expr {

/// Physical dimension of a number in an expression: a product of powers of m, kg and s, or an angle
/// (rad). A plain number is a number without a dimension (3, a count, the ratio of two lengths); it
/// is compatible with every dimension. The dimension of a number that is written without a unit is
/// unknown unless the number is obviously a count (700 may mean 700 kg/m^3). A product or quotient
/// with an unknown dimension is unknown, too. is_plain() is also true for an unknown dimension.
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
  /// Returns the SI unit of the dimension: "m", "kg/m^3", "N"; "1" for a plain number or an unknown
  /// dimension.
  std::string Text() const;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
  friend constexpr auto operator<=>(const Dimension&, const Dimension&) = default;
  /// Product and quotient of two dimensions. An angle remains only if the result is an angle alone;
  /// otherwise rad counts as 1: N m/rad times rad is N m, and rad times rad is a plain number.
  friend Dimension operator*(const Dimension& a, const Dimension& b);
  friend Dimension operator/(const Dimension& a, const Dimension& b);
  /// Returns the dimension of `base` raised to `exponent`. Returns an unknown dimension if `base`
  /// is unknown, if a resulting exponent of m, kg or s is not a whole number, or if its absolute
  /// value is above 20.
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

/// Returns the common dimension of two operands that are added or compared. A plain number, or a
/// number of unknown dimension, takes the dimension of the other operand. Returns nullopt if the
/// operands have two different dimensions.
std::optional<Dimension> CommonDimension(const Dimension& a, const Dimension& b);

/// Physical dimensions of the components of a vector, in order. A single item applies to all
/// components; an empty list means that the dimensions are unknown.
using Dimensions = std::vector<Dimension>;
Dimension DimensionAt(const Dimensions& dimensions, std::size_t component);

/// A unit as written in a spec, in the header of a CSV table or in the field table (fields.h): "m",
/// "kg/m^3", "Nm s/rad", "1".
struct NamedUnit {
  Dimension dimension;
  bool is_si = true;  // false for a unit with a factor other than 1, such as "mm"
};
/// Returns the unit that the text represents; nullopt if the text is not a unit.
std::optional<NamedUnit> FindUnit(std::string_view text);

}  // namespace mjforge::expr
