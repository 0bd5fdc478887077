// Functions of ValueReader that read numbers, expressions, ranges and vectors, and report errors.

#include "mjforge/spec/value_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;
using expr::Type;

bool IsYamlNotFinite(std::string_view text) {
  const std::string_view bare =
      text.starts_with('-') || text.starts_with('+') ? text.substr(1) : text;
  return expr::HasWord(".inf .Inf .INF .nan .NaN .NAN", bare);
}

// Returns true if the node is a piece of an expression that YAML split at a comma: `[max(a, b), 0]`
// has the items `max(a`, `b)` and `0`.
bool IsCutAtComma(const YamlNode& node) {
  return node.flow && !node.quoted &&
         std::ranges::count(node.text, '(') != std::ranges::count(node.text, ')');
}

// Returns the dimensions of an expression. Returns an empty list (unknown) for a plain constant,
// which may have any unit (2 for 2 kg).
expr::Dimensions MeasureOf(const expr::Expression& expression) {
  const bool is_plain = expression.constant() && expression.dimension().is_plain();
  return is_plain ? expr::Dimensions() : expr::Dimensions{expression.dimension()};
}

}  // namespace

void UsedNames::Add(const UsedNames& other) {
  names.insert(other.names.begin(), other.names.end());
  members.insert(other.members.begin(), other.members.end());
  materials.insert(other.materials.begin(), other.materials.end());
  any_material |= other.any_material;
}

void UsedNames::AddName(std::string_view name) {
  const std::size_t point = name.find('.');
  names.emplace(name.substr(0, point));
  if (point != std::string_view::npos) members.emplace(name);
}

bool UsedNames::HasMember(std::string_view prefix) const {
  const auto first = members.lower_bound(prefix);
  return first != members.end() && first->starts_with(prefix);
}

std::optional<std::size_t> FindRange(std::string_view text) {
  const auto dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  if (Trim(text.substr(0, dots)).empty() || Trim(text.substr(dots + 2)).empty())
    return std::nullopt;
  // Leaves dots inside parentheses to the parser of expressions, which reports the range.
  const std::string_view before = text.substr(0, dots);
  if (std::ranges::count(before, '(') != std::ranges::count(before, ')')) return std::nullopt;
  return dots;
}

void CollectNames(const YamlNode& node, std::vector<std::string>& names) {
  const auto add = [&names](std::string_view text) {
    for (std::string& name : expr::NamesUsedIn(text)) names.push_back(std::move(name));
  };
  for (const YamlNode& item : node.items) CollectNames(item, names);
  for (const auto& pair : node.pairs) {
    if (!IsAnnotationKey(pair.key)) CollectNames(pair.value, names);
  }
  if (node.kind != YamlNode::Kind::kScalar) return;
  const std::string_view text = node.text;
  if (text.find("${") != std::string_view::npos) {
    for (auto at = text.find("${"); at != std::string_view::npos; at = text.find("${", at + 2)) {
      add(text.substr(at + 2, text.find('}', at) - at - 2));
    }
  } else if (const auto dots = FindRange(text)) {
    add(text.substr(0, *dots));
    add(text.substr(*dots + 2));
  } else if (!node.quoted || !std::ranges::all_of(text, expr::IsNameCharacter)) {
    add(text);
  }
}

SourceMark ValueReader::At(SourceMark mark, std::size_t offset) const {
  const std::string_view line = sources_.Line(mark);
  const std::size_t start = mark.column - 1;
  if (start < line.size() && (line[start] == '"' || line[start] == '\'')) ++offset;
  // An offset outside the line means that the text is folded over several lines. The start of the
  // text is then the best position.
  if (offset <= line.size() && start + offset <= line.size()) {
    mark.column += static_cast<std::uint32_t>(offset);
  }
  return mark;
}

Value ValueReader::Wrong(const YamlNode& node, std::string_view expected) {
  const std::string given = node.kind == YamlNode::Kind::kScalar ? fmt::format("'{}'", node.text)
                                                                 : std::string(KindName(node));
  findings_.Add(Code::kSpecWrongType, node.mark,
                fmt::format("expected {}, got {}", expected, given));
  return SubstituteFor(node);
}

Value ValueReader::SubstituteFor(const YamlNode& node) {
  return Value{.mark = node.mark, .components = 0, .form = 1.0};
}

Value ValueReader::Read(const FieldInfo& field, const YamlNode& node, Motion motion) {
  if (field.kind == FieldKind::kPosition) return ReadPosition(field, node, motion);
  Value value = ReadForm(field, node);
  CheckBounds(field, value, 0);
  CheckUnits(field, value, 0, motion);
  if (field.key == "material") NoteMaterials(value);
  return value;
}

void ValueReader::NoteMaterials(const Value& value) {
  if (const auto literal = LiteralText(value)) {
    uses_.materials.emplace(*literal);
  } else if (const auto* draw = std::get_if<Draw>(&value.form)) {
    for (const Value& option : draw->arguments) NoteMaterials(option);
  } else {
    uses_.any_material = true;
  }
}

Value ValueReader::ReadForm(const FieldInfo& expected, const YamlNode& node) {
  switch (expected.kind) {
    case FieldKind::kNumber:
    case FieldKind::kInteger:
      return ReadNumber(node);
    case FieldKind::kBoolean:
      return ReadBoolean(node);
    case FieldKind::kWord:
      return ReadWord(expected, node);
    case FieldKind::kText:
      return ReadText(node);
    case FieldKind::kNumbers:
      return ReadVector(expected, node);
    case FieldKind::kPoints:
      return ReadPoints(expected, node);
    case FieldKind::kOutlines:
      return ReadOutlines(expected, node);
    default:
      return ReadAnything(node);
  }
}

std::optional<expr::Expression> ValueReader::Compile(const YamlNode& node, std::size_t begin,
                                                     std::size_t length,
                                                     expr::Expression::Result result) {
  expr::Error error;
  auto expression = expr::Expression::Compile(std::string_view(node.text).substr(begin, length),
                                              names_, error, result);
  if (!expression) {
    if (IsCutAtComma(node)) {
      error.hint =
          "a comma ends an item of a list in brackets; quote the expression: "
          "[\"max(a, b)\", 0]";
    }
    Report(std::move(error), node.mark, begin);
    return expression;
  }
  for (const auto& input : expression->inputs()) uses_.AddName(input.name);
  for (const std::string& function : expression->functions()) uses_.AddName(function);
  return expression;
}

void ValueReader::Report(expr::Error error, SourceMark mark, std::size_t begin) {
  const SourceMark call = mark;
  const expr::SpecFunction* function = names_.FindFunction(error.function);
  if (function != nullptr) {
    mark = function->mark;
    begin = 0;
  }
  diag::Finding& finding = findings_.Add(error.code, At(mark, begin + error.offset),
                                         std::move(error.message), std::move(error.hint));
  if (function != nullptr) finding.notes.push_back({call, "called from here"});
}

void ValueReader::CheckBody(const expr::SpecFunction& function) {
  expr::Error error;
  if (!expr::Expression::Compile(function.body, names_, error))
    Report(std::move(error), function.mark, 0);
}

Value ValueReader::ReadExpression(const YamlNode& node, expr::Expression::Result result) {
  Value value = SubstituteFor(node);
  auto expression = Compile(node, 0, node.text.size(), result);
  if (!expression) return value;
  value.type = expression->type();
  value.components = 1;
  value.dimensions = MeasureOf(*expression);
  if (value.type == Type::kText) {
    value.form = Text{{{.literal = {}, .expression = std::move(expression)}}};
  } else {
    value.form = std::move(*expression);
  }
  return value;
}

Value ValueReader::ReadRange(const YamlNode& node, std::size_t dots) {
  Value value = SubstituteFor(node);
  draws_.random = true;
  Draw draw;
  const std::pair<std::size_t, std::size_t> ends[] = {{0, dots},
                                                      {dots + 2, node.text.size() - dots - 2}};
  for (const auto& [begin, length] : ends) {
    const std::string_view part = std::string_view(node.text).substr(begin, length);
    const std::size_t blanks = part.find_first_not_of(" \t\r\n");
    Value end{.mark = At(node.mark, begin + blanks)};
    auto expression = Compile(node, begin + blanks, length - blanks);
    if (!expression) return value;
    if (expression->type() != Type::kNumber) {
      findings_.Add(Code::kSpecWrongType, end.mark, "the end of a range must be a number");
      return value;
    }
    end.dimensions = MeasureOf(*expression);
    end.form = std::move(*expression);
    draw.arguments.push_back(std::move(end));
  }
  CheckRangeOrder(draw.arguments[0], draw.arguments[1], node.mark);
  value.components = 1;
  value.dimensions = Agree("the ends of a range", draw.arguments);
  value.form = std::move(draw);
  return value;
}

void ValueReader::CheckRangeOrder(const Value& lo, const Value& hi, SourceMark mark) {
  const auto low = ConstantOf(lo);
  const auto high = ConstantOf(hi);
  if (low && high && *low > *high) {
    findings_.Add(Code::kSpecEmptyRange, mark,
                  fmt::format("range {} .. {} is empty: its lower end is above its upper end",
                              expr::NumberText(*low), expr::NumberText(*high)),
                  "swap the two");
  }
}

Value ValueReader::ReadNumber(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kMap) return ReadMapping({.kind = FieldKind::kNumber}, node, {});
  if (node.kind != YamlNode::Kind::kScalar) return Wrong(node, "a number");
  if (const auto number = expr::ParseNumber(node.text)) {
    if (node.quoted) {
      findings_.Add(Code::kSpecWrongType, node.mark,
                    fmt::format("expected a number, got the text '{}'", node.text),
                    "a quoted number is text: drop the quotes");
    }
    return Value{.mark = node.mark, .form = *number};
  }
  if (IsBooleanWord(node)) return Wrong(node, "a number");
  if (IsYamlNotFinite(node.text)) return Wrong(node, "a finite number");
  if (node.text.find("${") != std::string::npos) {
    findings_.Add(Code::kSpecWrongType, node.mark,
                  fmt::format("expected a number, got the text '{}'", node.text),
                  "a number is an expression without ${}, such as w + 2 * i; names cannot be "
                  "composed in it");
    return SubstituteFor(node);
  }
  if (const auto dots = FindRange(node.text)) return ReadRange(node, *dots);
  Value value = ReadExpression(node);
  if (value.type != Type::kNumber) {
    findings_.Add(Code::kSpecWrongType, node.mark,
                  fmt::format("expected a number, but '{}' is true or false", node.text));
    return SubstituteFor(node);
  }
  return value;
}

const expr::SymbolTable::Variable* ValueReader::LoneName(const YamlNode& node) const {
  if (node.kind != YamlNode::Kind::kScalar || node.quoted) return nullptr;
  return names_.Find(Trim(node.text));
}

Value ValueReader::Reference(const expr::SymbolTable::Variable& variable, const YamlNode& node) {
  uses_.AddName(variable.name);
  return Value{.mark = node.mark,
               .type = variable.type,
               .components = variable.components,
               .is_list = variable.is_list(),
               .dimensions = variable.dimensions,
               .form = VariableReference{variable.name, variable.slot, variable.list}};
}

Value ValueReader::ReadVector(const FieldInfo& expected, const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kMap) return ReadMapping(expected, node, {});
  if (node.kind == YamlNode::Kind::kList) return ReadList(expected, node);
  if (node.kind == YamlNode::Kind::kScalar && !node.quoted && node.text == "random" &&
      expected.min_count == 4 && expected.max_count == 4 && names_.Find("random") == nullptr) {
    CheckMeaning(false, expected, node);
    draws_.random = true;
    return Value{.mark = node.mark,
                 .components = 4,
                 .dimensions = {expr::Dimension::Count()},
                 .form = RandomRotation{}};
  }
  Value value;
  if (const auto* variable = LoneName(node); variable && variable->components > 1) {
    value = Reference(*variable, node);
  } else {
    value = ReadNumber(node);
  }
  if (value.components != 0) CheckCount(expected, value);
  return value;
}

void ValueReader::CheckCount(const FieldInfo& expected, const Value& value) {
  const int min = expected.min_count;
  const int max = expected.max_count;
  if (min <= value.components && value.components <= max) return;
  findings_.Add(Code::kSpecWrongLength, value.mark,
                fmt::format("expected {} numbers, got {}",
                            min == max ? fmt::format("{}", min) : fmt::format("{} to {}", min, max),
                            value.components));
}

Value ValueReader::ReadList(const FieldInfo& expected, const YamlNode& node) {
  Value value{.mark = node.mark, .components = static_cast<int>(node.items.size())};
  const bool cut = std::ranges::any_of(node.items, IsCutAtComma);
  if (!cut) CheckCount(expected, value);
  List list;
  bool reported_cut = false;
  for (const YamlNode& item : node.items) {
    // Reports only the first piece of a split expression, because the other pieces belong to the
    // same mistake.
    if (IsCutAtComma(item) && std::exchange(reported_cut, true)) continue;
    list.items.push_back(ReadNumber(item));
    value.dimensions.push_back(DimensionAt(list.items.back().dimensions, 0));
  }
  const auto is_first = [&](const auto& one) { return one == value.dimensions.front(); };
  if (std::ranges::all_of(value.dimensions, is_first)) value.dimensions.resize(1);
  if (cut) value.components = 0;
  value.form = std::move(list);
  return value;
}

Value ValueReader::ReadAnyScalar(const YamlNode& node) {
  if (node.text.find("${") != std::string::npos) return ReadText(node);
  if (IsBooleanWord(node)) return ReadBoolean(node);
  if (IsQuotedNumber(node)) return ReadText(node);
  if (expr::ParseNumber(node.text) || IsYamlNotFinite(node.text)) return ReadNumber(node);
  if (FindRange(node.text) && !LooksLikeText(node)) return ReadNumber(node);
  if (const auto* variable = LoneName(node)) return Reference(*variable, node);
  if (node.text != "pi" && LooksLikeText(node)) return ReadText(node);
  return ReadExpression(node, expr::Expression::Result::kAny);
}

Value ValueReader::ReadAnything(const YamlNode& node,
                                std::span<const std::string_view> extra_keys) {
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return Wrong(node, "a value");
    case YamlNode::Kind::kScalar:
      return ReadAnyScalar(node);
    case YamlNode::Kind::kList:
      if (node.items.size() > 4 || ItemType(node) != Type::kNumber)
        return ReadItems(ItemType(node), node);
      // A list of one number is a number.
      if (node.items.size() == 1) return ReadNumber(node.items.front());
      return ReadList({.kind = FieldKind::kNumbers, .min_count = 2, .max_count = 4}, node);
    case YamlNode::Kind::kMap:
      return ReadMapping({.kind = FieldKind::kAnything}, node, extra_keys);
  }
  return {};
}

}  // namespace mjforge::spec
