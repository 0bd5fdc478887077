// The reader of values: literals, expressions, ranges, draws, lists, points and text.

#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/fields.h"
#include "mjforge/spec/values.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

/// Names that the values of a spec refer to.
struct UsedNames {
  std::set<std::string, std::less<>> names;    // parameters, functions, loop variables, bodies
  std::set<std::string, std::less<>> members;  // members with their owners: "arm.top", "size.x"
  std::set<std::string, std::less<>> materials;
  bool any_material = false;  // true if a material's name is computed, so that any may be used

  void Add(const UsedNames& other);
  /// Adds a name in an expression: "r", "size.x", "arm.top".
  void AddName(std::string_view name);
  /// Returns true if an expression uses a member whose full name begins with `prefix`
  /// ("arm.subtree_").
  bool HasMember(std::string_view prefix) const;
};

/// Reads values whose expressions can use `names`. For a wrong value, adds a finding and returns a
/// substitute that passes all later checks, so that reading continues.
class ValueReader {
 public:
  ValueReader(expr::SymbolTable& names, const diag::Sources& sources, diag::Findings& findings)
      : names_(names), sources_(sources), findings_(findings) {}

  /// Reads the value of a field whose kind is a value (HoldsValue()), not a structure. `motion` is
  /// the motion of the joint to which the field belongs.
  Value Read(const FieldInfo& field, const YamlNode& node, Motion motion = Motion::kAny);

  /// Reads a value whose type follows from its form (a parameter, an option of a choice). A mapping
  /// may have `extra_keys` besides the distribution.
  Value ReadAnything(const YamlNode& node, std::span<const std::string_view> extra_keys = {});

  /// Reads a value of any kind. If `wanted` is a list, a short list in brackets is also read as a
  /// list, not as a vector.
  Value ReadLike(const Value& wanted, const YamlNode& node,
                 std::span<const std::string_view> extra_keys = {});
  /// Reads a list in brackets, or the name of a list or vector. Returns nullopt for other nodes.
  std::optional<Value> ReadListOrName(const YamlNode& node);

  /// Reads the mapping of a draw (`{normal: [1, 0.1]}`) for a field of this kind.
  Value ReadDrawOf(FieldKind kind, const YamlNode& map,
                   std::span<const std::string_view> extra_keys = {}) {
    return ReadMapping({.kind = kind}, map, extra_keys);
  }
  /// Returns true if the node is a text that contains no `${...}`, and is neither an expression nor
  /// the name of a variable.
  bool IsPlainText(const YamlNode& node) const;

  /// Reads `for:`. The loop variables remain declared until EndLoops().
  std::vector<Loop> ReadLoops(const YamlNode& loops);
  void EndLoops(const std::vector<Loop>& loops);
  /// Returns true if the key of `pair` is a valid, unused name for a loop variable or a local
  /// value. Otherwise adds a finding.
  bool CheckLocalName(std::string_view what, const YamlNode::Pair& pair);

  /// Reads the value of a field of kind kPosition for a joint with this motion.
  Value ReadPosition(const FieldInfo& field, const YamlNode& node, Motion motion);
  Value ReadNumber(const YamlNode& node);
  Value ReadText(const YamlNode& node);
  /// Reads a boolean expression. Returns nullopt, and adds a finding, if the expression is not
  /// valid.
  std::optional<expr::Expression> ReadCondition(const YamlNode& node);
  /// Reports a number whose unit does not fit the field. `position` is the index of the value's
  /// first number among the numbers of the field.
  void CheckUnits(const FieldInfo& field, const Value& value, int position = 0,
                  Motion motion = Motion::kAny);
  /// Returns true if the value has the dimensions `wanted`. Otherwise adds a finding, in which
  /// `what` describes the value ("parameter 'r'").
  bool CheckUnit(std::string_view what, const expr::Dimensions& wanted, const Value& value);
  /// Reports a value with a unit where only a plain number is allowed. `what` describes the value
  /// ("a weight").
  void CheckPlain(std::string_view what, const Value& value);
  /// Returns the kinds of draws (values chosen anew for each variant) that were read so far.
  const DrawKinds& draws() const { return draws_; }
  /// Returns the names that the values read so far refer to.
  const UsedNames& uses() const { return uses_; }
  /// Adds the names that the values of another reader refer to.
  void AddUses(const ValueReader& other) { uses_.Add(other.uses_); }
  /// Reports errors in the body of a function. The arguments of the function must be declared
  /// before.
  void CheckBody(const expr::SpecFunction& function);
  /// Reads text without interpolation. Returns an empty text after adding a finding.
  std::string ReadPlainText(std::string_view what, const YamlNode& node);

 private:
  // Reads a value of the form that a field accepts, without checking bounds and units. `expected`
  // has no key if the value belongs to a parameter or is an item of a list.
  Value ReadForm(const FieldInfo& expected, const YamlNode& node);
  Value ReadBoolean(const YamlNode& node);
  Value ReadWord(const FieldInfo& expected, const YamlNode& node);
  Value ReadVector(const FieldInfo& expected, const YamlNode& node);
  Value ReadList(const FieldInfo& expected, const YamlNode& node);
  Value ReadOutlines(const FieldInfo& expected, const YamlNode& node);
  Value ReadAxisOutlines(const FieldInfo& expected, const YamlNode& map);
  Value ReadPoints(const FieldInfo& expected, const YamlNode& node);
  Value ReadPoint(const FieldInfo& expected, const YamlNode& node);
  // Reads {for: loops, KEY: value} with the key `key`; calls `read` for the node of the value.
  template <typename Reader>
  Value ReadPointLoop(const YamlNode& map, std::string_view key, Reader&& read);
  Value ReadArc(const FieldInfo& expected, const YamlNode& map);
  std::vector<Value> ReadArcMeasures(const YamlNode& arc);  // radius, start angle, end angle
  /// Reads the key `axis` of the mapping: x, y or z (default), as 0, 1 or 2. `what` names the
  /// mapping in findings.
  Value ReadAxis(const YamlNode& map, std::string_view what, std::string_view hint);
  void AllowKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                 std::string_view what);
  Value ReadItems(expr::Type type, const YamlNode& node);
  expr::Type ItemType(const YamlNode& list) const;
  bool IsText(const YamlNode& node) const;
  bool IsBoolean(const YamlNode& node) const;
  Value ReadListForm(const FieldInfo& expected, const YamlNode& map, const YamlNode::Pair& main);
  Value ReadEach(const YamlNode& map);
  Value ReadArrangement(std::string_view key, const YamlNode& map);
  std::shared_ptr<const Value> ReadCount(const YamlNode& node);
  Value ReadAnyScalar(const YamlNode& node);
  Value ReadMapping(const FieldInfo& expected, const YamlNode& node,
                    std::span<const std::string_view> extra_keys);
  void ReportUnknownKey(const YamlNode::Pair& pair, const std::vector<std::string_view>& known,
                        bool lost);
  Value ReadDraw(const DistributionInfo& info, const FieldInfo& expected, const YamlNode& map);
  bool ReadArguments(const DistributionInfo& info, const YamlNode& node, Draw& draw);
  void ReadOptions(const FieldInfo& expected, const YamlNode& list, Draw& draw, Value& value);
  void ReadDrawOption(const DistributionInfo& info, const YamlNode& node, Draw& draw);
  void ReadExact(const YamlNode& node, Draw& draw);
  void CheckMeaning(bool is_color, const FieldInfo& expected, const YamlNode& node);
  Value ReadVectorForm(std::string_view key, const FieldInfo& expected, const YamlNode& node);
  Value ReadRange(const YamlNode& node, std::size_t dots);
  Value ReadExpression(const YamlNode& node, expr::Expression::Result result = {});
  std::optional<expr::Expression> Compile(const YamlNode& node, std::size_t begin,
                                          std::size_t length, expr::Expression::Result result = {});
  Value Reference(const expr::SymbolTable::Variable& variable, const YamlNode& node);
  void NoteMaterials(const Value& value);
  const expr::SymbolTable::Variable* LoneName(const YamlNode& node) const;
  bool LooksLikeText(const YamlNode& node) const;
  // Returns the common dimensions of values. If the dimensions differ, adds a finding and returns
  // an empty list, which means unknown dimensions.
  expr::Dimensions Agree(std::string_view what, std::span<const Value> values);
  // Returns the dimensions of the values that a draw produces.
  expr::Dimensions DimensionsOfDraw(const DistributionInfo& info, const FieldInfo& expected,
                                    const Draw& draw);
  // Reports a vector with fewer or more numbers than expected.
  void CheckCount(const FieldInfo& expected, const Value& value);
  void CheckRangeOrder(const Value& lo, const Value& hi, diag::SourceMark mark);
  void CheckBounds(const FieldInfo& field, const Value& value, int position);
  void CheckDrawBounds(const FieldInfo& field, const Draw& draw, int position);
  Value Wrong(const YamlNode& node, std::string_view expected);
  // Returns a value with 0 components, which passes all later checks in place of a wrong value.
  static Value SubstituteFor(const YamlNode& node);
  // Adds a finding for an error in a text that begins `begin` bytes after `mark`.
  void Report(expr::Error error, diag::SourceMark mark, std::size_t begin);
  diag::SourceMark At(diag::SourceMark mark, std::size_t offset) const;

  expr::SymbolTable& names_;
  const diag::Sources& sources_;
  diag::Findings& findings_;
  DrawKinds draws_;
  UsedNames uses_;
};

/// Returns the byte offset of the dots in a range `lo .. hi`; nullopt if the text is not a range.
std::optional<std::size_t> FindRange(std::string_view text);

/// Returns true for keys that make a mapping a draw: `normal`, `each`, `about`.
bool IsDrawKey(std::string_view key);

/// Returns the text without blanks at its ends.
std::string_view Trim(std::string_view text);
/// Returns the pieces of a text between separators.
std::vector<std::string_view> Split(std::string_view text, std::string_view separator);

/// Appends the names in the expressions of a node and its inner nodes; names may repeat.
void CollectNames(const YamlNode& node, std::vector<std::string>& names);

/// Returns true for the keys of a parameter's mapping that describe its value: doc, unit, section.
inline bool IsAnnotationKey(std::string_view key) {
  return key == "doc" || key == "unit" || key == "section";
}

}  // namespace mjforge::spec
