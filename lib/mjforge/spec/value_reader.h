#pragma once

// YAML nodes -> Values: literals, expressions, ranges, distributions, text.

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

/// What values refer to.
struct UsedNames {
  std::set<std::string, std::less<>> names;      // of parameters, loops and bodies
  std::set<std::string, std::less<>> materials;  // as written
  bool any_material = false;                     // a material's name is composed

  void Add(const UsedNames& other);
  /// A name as an expression writes it: "r", "size.x", "arm.top".
  void AddName(std::string_view name) { names.emplace(name.substr(0, name.find('.'))); }
};

/// Reads values in the scope of `names`. A value that is wrong adds a finding and comes back as
/// something harmless, so that reading continues.
class ValueReader {
 public:
  ValueReader(expr::Names& names, const diag::Sources& sources, diag::Findings& findings)
      : names_(names), sources_(sources), findings_(findings) {}

  /// The value of a field whose slot holds one (not structure). `motion`: of the joint whose field
  /// it is.
  Value Read(const FieldInfo& field, const YamlNode& node, Motion motion = Motion::kAny);

  /// A value of any kind, whose type follows from its form: parameters, options. A mapping may have
  /// `extra_keys` besides the distribution.
  Value ReadAnything(const YamlNode& node, std::span<const std::string_view> extra_keys = {});

  /// As ReadAnything; where `wanted` is a list, one in brackets is, too, however short.
  Value ReadLike(const Value& wanted, const YamlNode& node,
                 std::span<const std::string_view> extra_keys = {});
  /// A list in brackets, of numbers or texts; or the name of a list or a vector.
  std::optional<Value> ReadListOrName(const YamlNode& node);

  /// The mapping of a draw where only numbers or only texts may be, or anything.
  Value ReadDrawOf(FieldKind kind, const YamlNode& map,
                   std::span<const std::string_view> extra_keys = {}) {
    return ReadMapping({.kind = kind}, map, extra_keys);
  }
  /// Whether it can only be text, and has no expressions.
  bool IsPlainText(const YamlNode& node) const;

  /// `for:`. The variables stay declared until EndLoops.
  std::vector<Loop> ReadLoops(const YamlNode& loops);
  void EndLoops(const std::vector<Loop>& loops);
  /// Whether the name of a loop variable or a local value is free; else a finding.
  bool CheckLocalName(std::string_view what, const YamlNode::Pair& pair);

  Value ReadNumber(const YamlNode& node);
  Value ReadText(const YamlNode& node);
  /// A boolean expression; nothing if it is wrong.
  std::optional<expr::Expression> ReadCondition(const YamlNode& node);
  /// Reports a number whose unit is not that of the field. `position`: of the first number among
  /// the field's.
  void CheckUnits(const FieldInfo& field, const Value& value, int position = 0,
                  Motion motion = Motion::kAny);
  /// Whether the value is in the unit of `what` ("parameter 'r'"); else a finding.
  bool CheckUnit(std::string_view what, const expr::Dimensions& wanted, const Value& value);
  /// Reports a number that has a unit where `what` ("a weight") has none.
  void CheckPlain(std::string_view what, const Value& value);
  /// Whether some value read so far is a choice with `exact: true`.
  bool has_exact_choice() const { return has_exact_choice_; }
  /// What the values read so far refer to.
  const UsedNames& uses() const { return uses_; }
  /// Counts what another reader's values refer to.
  void AddUses(const ValueReader& other) { uses_.Add(other.uses_); }
  /// Reports what is wrong with the body of a function, whose arguments are declared.
  void CheckBody(const expr::Formula& formula);
  /// Text without interpolation, empty if wrong.
  std::string ReadPlainText(std::string_view what, const YamlNode& node);

 private:
  // What the place allows: the field's slot, and counts for vectors.
  struct ExpectedForm {
    FieldKind kind = FieldKind::kAnything;
    int min_count = 1;
    int max_count = 1;
    std::string_view words = {};
    std::string_view key = {};  // of the field
  };
  Value Read(const ExpectedForm& expected, const YamlNode& node);
  Value ReadBoolean(const YamlNode& node);
  Value ReadWord(const ExpectedForm& expected, const YamlNode& node);
  Value ReadVector(const ExpectedForm& expected, const YamlNode& node);
  Value ReadList(const ExpectedForm& expected, const YamlNode& node);
  Value ReadOutlines(const ExpectedForm& expected, const YamlNode& node);
  Value ReadPoints(const ExpectedForm& expected, const YamlNode& node);
  Value ReadPoint(const ExpectedForm& expected, const YamlNode& node);
  /// What `key` holds, read by `read`, for each value of the loops of `for`.
  template <typename Reader>
  Value ReadPointLoop(const YamlNode& map, std::string_view key, Reader&& read);
  Value ReadArc(const ExpectedForm& expected, const YamlNode& map);
  void AllowKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                 std::string_view what);
  Value ReadItems(expr::Type type, const YamlNode& node);
  expr::Type ItemType(const YamlNode& list) const;
  bool IsText(const YamlNode& node) const;
  Value ReadListForm(const ExpectedForm& expected, const YamlNode& map, const YamlNode::Pair& main);
  Value ReadEach(const YamlNode& map);
  Value ReadArrangement(std::string_view key, const YamlNode& map);
  std::shared_ptr<const Value> ReadCount(const YamlNode& node);
  Value ReadAnyScalar(const YamlNode& node);
  Value ReadMapping(const ExpectedForm& expected, const YamlNode& node,
                    std::span<const std::string_view> extra_keys);
  void ReportUnknownKey(const YamlNode::Pair& pair, const std::vector<std::string_view>& known,
                        bool lost);
  Value ReadDraw(const DistributionInfo& info, const ExpectedForm& expected, const YamlNode& map);
  bool ReadArguments(const DistributionInfo& info, const YamlNode& node, Draw& draw);
  void ReadOptions(const ExpectedForm& expected, const YamlNode& list, Draw& draw, Value& value);
  void ReadDrawOption(const DistributionInfo& info, const YamlNode& node, Draw& draw);
  void ReadExact(const YamlNode& node, Draw& draw);
  bool IsVectorForm(std::string_view key, const ExpectedForm& expected) const;
  void CheckMeaning(bool is_color, const ExpectedForm& expected, const YamlNode& node);
  Value ReadVectorForm(std::string_view key, const ExpectedForm& expected, const YamlNode& node);
  Value ReadRange(const YamlNode& node, std::size_t dots);
  Value ReadExpression(const YamlNode& node, expr::Expression::Result result = {});
  std::optional<expr::Expression> Compile(const YamlNode& node, std::size_t begin,
                                          std::size_t length, expr::Expression::Result result = {});
  Value Reference(const expr::Names::Variable& variable, const YamlNode& node);
  void NoteMaterials(const Value& value);
  const expr::Names::Variable* LoneName(const YamlNode& node) const;
  bool LooksLikeText(const YamlNode& node) const;
  /// What numbers of one unit measure; a finding if they have different ones.
  expr::Dimensions Agree(std::string_view what, std::span<const Value> values);
  /// What a draw measures.
  expr::Dimensions Measured(const DistributionInfo& info, const ExpectedForm& expected,
                            const Draw& draw);
  void CheckRangeOrder(const Value& lo, const Value& hi, diag::SourceMark mark);
  void CheckBounds(const FieldInfo& field, const Value& value, int position);
  void CheckDrawBounds(const FieldInfo& field, const Draw& draw, int position);
  Value Wrong(const YamlNode& node, std::string_view expected);
  // Stands for a value that was reported: passes every later check.
  static Value Harmless(const YamlNode& node);
  /// The place of an error in `text`, which stands at `mark` from byte `begin` on.
  void Report(expr::Error error, diag::SourceMark mark, std::size_t begin);
  diag::SourceMark At(diag::SourceMark mark, std::size_t offset) const;

  expr::Names& names_;
  const diag::Sources& sources_;
  diag::Findings& findings_;
  bool has_exact_choice_ = false;
  UsedNames uses_;
};

/// Where the two dots of `lo .. hi` are in a text; nothing if it is not a range.
std::optional<std::size_t> FindRange(std::string_view text);

/// Whether a mapping with this key says how a value is drawn: `normal`, `each`, `about`.
bool IsDrawKey(std::string_view key);

/// A plain `true` or `false`.
bool IsBooleanWord(const YamlNode& node);

/// Without blanks at the ends.
std::string_view Trim(std::string_view text);
/// The pieces of a text between separators.
std::vector<std::string_view> Split(std::string_view text, std::string_view separator);

/// The names that a node's expressions use, in order of first use, with repeats.
void CollectNames(const YamlNode& node, std::vector<std::string>& names);

}  // namespace mjforge::spec
