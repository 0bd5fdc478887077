// Values of a spec, parsed and type-checked but not drawn: numbers, texts, lists, draws.

#pragma once

#include <functional>
#include <map>
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
struct Loop;

/// A reference to a whole variable of any type, such as a parameter: `size: half_size`.
struct VariableReference {
  std::string name;
  int slot = 0;
  int list = -1;  // index in the expressions' array of lists; -1: not a list
};

/// A piece of a text: a literal, an interpolated expression, or a text variable.
struct TextPiece {
  std::string literal = {};
  std::optional<expr::Expression> expression = {};
  std::optional<VariableReference> variable = {};
};
/// Text with interpolated expressions.
struct Text {
  std::vector<TextPiece> pieces;
};

/// A list of numbers, texts, booleans, points or outlines.
struct List {
  std::vector<Value> items;
};

/// A list of `count` independent draws: {each: 22mm .. 35mm, count: 5}.
struct Each {
  std::shared_ptr<const Value> value;
  std::shared_ptr<const Value> count;
};

/// Items of a list in random order, without repetition: {shuffle: list}, {sample: list, count: 2}.
struct Arrangement {
  std::shared_ptr<const Value> list;
  std::shared_ptr<const Value> count;  // null: all items
};

/// A reference to the parameter ObjectSpec::shared[file]->parameters[position], which an imported
/// file declares.
struct SharedParameter {
  std::size_t file = 0;
  std::size_t position = 0;
};

/// Returns true if `number` is a valid length of a list: an integer from 0 to 100,000.
bool IsListLength(double number);
inline constexpr std::string_view kListLengthRule = "must be a whole number, 0 to 100000";

/// Index of the rows of a record by their keys.
struct RecordRows {
  std::map<double, std::size_t> numbers;  // row of each key; texts by expr::TextKey()
  std::vector<std::string> names;         // key of each row, as written
};

/// A draw from a distribution.
struct Draw {
  Distribution distribution = Distribution::kUniform;
  std::vector<Value> arguments;  // numbers; for choice and cycle the options
  std::vector<Value> limits;     // `clip` or `range`: two numbers; empty if not given
  std::vector<Value> weights;    // only for a choice: one number per option, or empty
  bool exact = false;            // only for a choice: the counts over a batch follow the weights
  /// Only for a column of a record: the option is not drawn, but looked up by the value of the
  /// record's key, which is in slot `key_slot`.
  std::shared_ptr<const RecordRows> rows;
  int key_slot = 0;

  /// Returns true for a choice and a cycle, whose `arguments` are options.
  bool is_choice() const {
    return distribution == Distribution::kChoice || distribution == Distribution::kCycle;
  }
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

/// An item of a list of points or outlines that is repeated for each value of the loop variables:
/// {for: {i: 8}, at: [x, y]} repeats a point, {for: {i: 8}, points: [...]} repeats an outline.
struct PointLoop {
  std::shared_ptr<const std::vector<Loop>> loops;  // the outermost loop first
  std::shared_ptr<const Value> at;                 // the repeated point or outline
};

/// An item of a list of points that stands for the points of an arc, including both ends: {arc:
/// [[x, y], radius, from, to], steps: 8} in the plane, {arc: [[x, y, z], radius, from, to], axis:
/// z} in space, or {arc: [p, q, r]} through three points.
struct Arc {
  std::shared_ptr<const Value> center;  // center, or the first of three points
  // Radius, start angle, end angle and, in space, the axis; or the second and third point.
  std::vector<Value> measures;
  std::shared_ptr<const Value> steps;
};

/// An item of a list of outlines: outlines of holes that go through the part along an axis, {axis:
/// x, outlines: [...]}.
struct AxisOutlines {
  std::size_t axis = 2;  // 0, 1 or 2: x, y or z
  std::shared_ptr<const Value> outlines;
};

/// Kinds of draws (values that are chosen anew for each variant) that occur in a spec.
struct DrawKinds {
  bool random = false;  // a draw that depends on the seed: any but `cycle`
  bool exact = false;   // a choice with `exact: true`, which depends on the batch size

  DrawKinds& operator|=(const DrawKinds& other) {
    random |= other.random;
    exact |= other.exact;
    return *this;
  }
};

/// A value as written in a spec, in any of its forms, with its type and dimensions.
struct Value {
  diag::SourceMark mark;
  expr::Type type = expr::Type::kNumber;
  int components = 1;    // components of a vector, or entries of a list of points; 0: wrong value
  bool is_list = false;  // a list of any length, of numbers, texts or booleans
  // Dimensions of a number, of a vector, or of each item of a list.
  expr::Dimensions dimensions = {};
  std::variant<double, bool, Text, expr::Expression, VariableReference, List, Draw, RandomRotation,
               RotationAbout, PointOnSphere, HsvColor, Each, Arrangement, SharedParameter,
               PointLoop, Arc, AxisOutlines>
      form = 0.0;
};

/// A loop `for: {i: n}`: the variable takes the values 0 to n-1, or the values of the list or
/// vector n.
struct Loop {
  int slot = 0;
  Value range;
  std::string variable;

  bool over_values() const { return range.is_list || range.components > 1; }
};

/// Returns true if both values are numbers, booleans, texts, vectors of the same length, or lists
/// of items of the same type.
bool IsSameKind(const Value& a, const Value& b);

/// Returns the units of the dimensions, "s, 1"; an empty text if the dimensions are unknown.
std::string UnitText(const expr::Dimensions& dimensions);
/// Returns true if any of the dimensions is known and differs from that of a plain number.
bool IsMeasured(const expr::Dimensions& dimensions);
/// Returns the dimensions of units such as "m" or "s, 1"; nullopt for any other text.
std::optional<expr::Dimensions> DimensionsOf(std::string_view units);

/// Declares the variable `index`, the index of the variant.
void DeclareIndex(expr::SymbolTable& names);
/// Declares a variable with the type of `value`.
const expr::SymbolTable::Variable& Declare(expr::SymbolTable& names, const std::string& name,
                                           const Value& value);

/// Returns true if any part of the value is drawn.
bool HasDraw(const Value& value);
/// Returns the number of a literal or of an expression without variables; nullopt for all other
/// values.
std::optional<double> ConstantOf(const Value& value);
/// Returns the text if it has no interpolation; nullopt for other values.
std::optional<std::string_view> LiteralText(const Value& value);

/// Returns the kind of a parameter or a value for messages: "3 numbers", "a list of texts".
std::string KindText(expr::Type type, std::size_t components);
std::string KindText(const Value& value);

/// Returns true if the number is valid for the field: finite, within the bounds, and an integer if
/// the field takes integers.
bool Holds(const FieldInfo& field, double number);
/// Returns the rule that a finite but invalid number violates: "must be at least 0".
std::string Rule(const FieldInfo& field, double number);

}  // namespace mjforge::spec
