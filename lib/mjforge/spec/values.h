#pragma once

// The value of a slot of a spec, parsed and type-checked but not drawn.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/distributions.h"
#include "mjforge/spec/fields.h"

namespace mjforge::spec {

struct Value;

/// Text with interpolated expressions: the pieces in order. A piece is a
/// literal, an expression (its number or text is written), or a text variable.
struct TextPiece {
  std::string literal;
  std::optional<expr::Expression> expression;
  int text_slot = -1;
};
struct Text {
  std::vector<TextPiece> pieces;
};

/// A whole parameter, of any type: `size: half_size`.
struct VariableReference {
  std::string name;
  int slot = 0;
};

struct List {
  std::vector<Value> items;
};

struct Draw {
  Distribution distribution = Distribution::kUniform;
  std::vector<Value> arguments;  // numbers; for choice and cycle the options
  std::vector<Value> limits;     // clip or range: none or two numbers
  std::vector<Value> weights;    // choice: none or one for each option
  bool exact = false;            // choice: the counts over a batch follow the weights
};

struct RandomRotation {};  // quat: random
struct RotationAbout {
  std::shared_ptr<const Value> axis;
};  // quat: {about: [x, y, z]}
struct PointOnSphere {
  std::shared_ptr<const Value> radius;
};  // pos: {on_sphere: r}
struct HsvColor {
  std::vector<Value> items;
};  // rgba: {hsv: [h, s, v, (a)]}, each 0 to 1

struct Value {
  diag::SourceMark mark;
  expr::Type type = expr::Type::kNumber;
  int components = 1;  // of a vector; a list of points counts its points; 0: it was reported
  std::variant<double, bool, Text, expr::Expression, VariableReference, List, Draw, RandomRotation,
               RotationAbout, PointOnSphere, HsvColor>
      form = 0.0;
};

/// Is any number in it drawn?
bool HasDraw(const Value& value);
/// Is any number in it drawn, or computed from a variable that varies, given by its slot?
bool Varies(const Value& value, const std::function<bool(int)>& variable_varies);

/// The number of a literal, or of an expression without names.
std::optional<double> ConstantOf(const Value& value);

/// The text if it has no interpolation; nothing otherwise.
std::optional<std::string_view> LiteralText(const Value& value);

/// What a parameter or a value is: "a number", "3 numbers", "text", "true or false".
std::string KindText(expr::Type type, std::size_t components);
std::string KindText(const Value& value);

/// Whether a field takes the number: it is finite, within the bounds, and whole if it must be.
bool Holds(const FieldInfo& field, double number);
/// What a finite number that does not hold must be: "must be at least 0".
std::string Rule(const FieldInfo& field, double number);

}  // namespace mjforge::spec
