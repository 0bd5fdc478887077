#pragma once

// The value of a slot of a spec, parsed and type-checked but not drawn.

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
  int list = -1;  // as expr::Names::Variable::list
};

/// Numbers or texts, or points.
struct List {
  std::vector<Value> items;
};

/// A list of `count` values, each drawn for itself: {each: 22mm .. 35mm, count: 5}.
struct Each {
  std::shared_ptr<const Value> value;
  std::shared_ptr<const Value> count;
};

/// Different items of a list in random order, `count` of them: {shuffle: list}, {sample: list,
/// count: 2}.
struct Arrangement {
  std::shared_ptr<const Value> list;
  std::shared_ptr<const Value> count;  // null: all
};

/// A parameter of an imported file: ObjectSpec::shared[file]->parameters[position].
struct SharedParameter {
  std::size_t file = 0;
  std::size_t position = 0;
};

/// Whether a list can have as many values: a whole number, at most 100,000.
bool IsListLength(double number);
inline constexpr std::string_view kListLengthRule = "must be a whole number, 0 to 100000";

/// The rows of a record.
struct RecordRows {
  std::map<double, std::size_t> numbers;  // of the rows, by key; of texts, their TextKey()s
  std::vector<std::string> names;         // of the keys as written
};

struct Draw {
  Distribution distribution = Distribution::kUniform;
  std::vector<Value> arguments;  // numbers; for choice and cycle the options
  std::vector<Value> limits;     // clip or range: none or two numbers
  std::vector<Value> weights;    // choice: none or one for each option
  bool exact = false;            // choice: the counts over a batch follow the weights
  /// A choice of one option for each row: it is not drawn, but that of the key in the slot.
  std::shared_ptr<const RecordRows> rows;
  int key_slot = 0;
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

/// In a list of points, one for each value of the variables: {for: {i: 8}, at: [x, y]}. In a list
/// of outlines, one for each: {for: {i: 8}, points: [...]}.
struct PointLoop {
  std::shared_ptr<const std::vector<Loop>> loops;  // outermost first
  std::shared_ptr<const Value> at;
};

/// In a list of points, those of an arc, both ends included: {arc: [[x, y], radius, from, to],
/// steps: 8}.
struct Arc {
  std::shared_ptr<const Value> center;
  std::vector<Value> measures;  // radius, from, to
  std::shared_ptr<const Value> steps;
};

struct Value {
  diag::SourceMark mark;
  expr::Type type = expr::Type::kNumber;
  int components = 1;    // of a vector; a list of points counts its points; 0: it was reported
  bool is_list = false;  // of numbers or texts, as `type` says; of any length
  expr::Dimensions dimensions = {};  // of numbers; of a list, those of each
  std::variant<double, bool, Text, expr::Expression, VariableReference, List, Draw, RandomRotation,
               RotationAbout, PointOnSphere, HsvColor, Each, Arrangement, SharedParameter,
               PointLoop, Arc>
      form = 0.0;
};

/// `for: {i: n}`: variable i runs over 0 .. n-1; over the values of a list or a vector where the
/// range is one.
struct Loop {
  int slot = 0;
  Value range;
  std::string variable;

  bool over_values() const { return range.is_list || range.components > 1; }
};

/// Whether both are numbers, texts, vectors of one length, or lists of numbers or texts.
bool IsSameKind(const Value& a, const Value& b);

/// "s, 1"; empty: unknown.
std::string UnitText(const expr::Dimensions& dimensions);
/// Whether anything in it is not a plain number.
bool IsMeasured(const expr::Dimensions& dimensions);
/// What "m" or "s, 1" says of a parameter; nothing if it names no units.
std::optional<expr::Dimensions> DimensionsOf(std::string_view units);

/// Declares `index`, the number of a variant.
void DeclareIndex(expr::Names& names);
/// Declares a name for what has such a value.
const expr::Names::Variable& Declare(expr::Names& names, std::string name, const Value& value);

/// Is any number in it drawn?
bool HasDraw(const Value& value);
/// Is any number in it drawn, or computed from a variable that varies, given by its slot?
bool Varies(const Value& value, const std::function<bool(int)>& variable_varies);

/// The number of a literal, or of an expression without names.
std::optional<double> ConstantOf(const Value& value);

/// The text if it has no interpolation; nothing otherwise.
std::optional<std::string_view> LiteralText(const Value& value);

/// What a parameter or a value is: "a number", "3 numbers", "text", "true or false", "a list of
/// texts".
std::string KindText(expr::Type type, std::size_t components);
std::string KindText(const Value& value);

/// Whether a field takes the number: it is finite, within the bounds, and whole if it must be.
bool Holds(const FieldInfo& field, double number);
/// What a finite number that does not hold must be: "must be at least 0".
std::string Rule(const FieldInfo& field, double number);

}  // namespace mjforge::spec
