// Errors of expressions: their messages and hints, with suggestions for misspelled names.
#include "mjforge/expr/error_messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/expr/builtins.h"

namespace mjforge::expr {
namespace {

using diag::Code;

std::string Quoted(const Token& token) {
  return token.kind == Token::Kind::kText ? fmt::format("the text '{}'", token.text)
                                          : fmt::format("'{}'", token.text);
}

std::string OperatorHint(const Token& before, const Token& token, const SymbolTable& names) {
  if (token.kind == Token::Kind::kName && FindUnitSuffix(token.text) != nullptr &&
      names.Find(token.text) == nullptr) {
    if (before.kind == Token::Kind::kNumber && before.unit.empty()) {
      return fmt::format("a unit follows its number without a space: {}{}", before.text,
                         token.text);
    }
    return fmt::format("only numbers carry units: multiply by 1{}", token.text);
  }
  const bool factor = before.kind == Token::Kind::kNumber || before.kind == Token::Kind::kName;
  if (!factor || token.kind != Token::Kind::kName) return {};
  return fmt::format("write {} * {}", before.text, token.text);
}

std::string ClosestName(std::string_view token, const SymbolTable& names) {
  auto candidates = diag::Mapped<std::string_view>(names.variables(), &SymbolTable::Variable::name);
  for (const BuiltinInfo& function : Builtins()) candidates.push_back(function.name);
  for (const auto& [name, function] : names.functions()) candidates.push_back(name);
  return diag::DidYouMean(token, candidates);
}

std::string ComponentList(const SymbolTable::Variable& variable) {
  const std::size_t count =
      std::min(static_cast<std::size_t>(variable.components), kComponents.size());
  std::string list;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) list += i + 1 == count ? " or " : ", ";
    list += fmt::format("{}.{}", variable.name, kComponents[i]);
  }
  return list;
}

Error Syntax(const Token& token, std::string message, std::string hint = {}) {
  return {Code::kExprSyntax, token.offset, std::move(message), std::move(hint)};
}

Error WrongType(const Token& token, std::string message, std::string hint = {}) {
  return {Code::kExprType, token.offset, std::move(message), std::move(hint)};
}

}  // namespace

Error MissingValue(std::span<const Token> tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (token.kind == Token::Kind::kEnd) {
    return at == 0 ? Syntax(token, "the expression is empty")
                   : Syntax(token, "the expression ends where a value is expected");
  }
  if (token.IsName("not")) {
    return Syntax(token, "'not' binds more loosely than what precedes it",
                  "put it in parentheses: (not ...)");
  }
  const Token* before = at > 0 ? &tokens[at - 1] : nullptr;
  const bool adjacent = before && before->offset + before->text.size() == token.offset;
  std::string hint;
  if (adjacent && token.IsSign("*") && before->IsSign("*")) hint = "write ^ for a power";
  if (token.IsSign("[")) hint = "an expression gives one value, not a list";
  if (adjacent && token.IsSign("=") && !before->IsSign("(")) {
    hint = "the comparisons are == != < <= > >=";
  }
  return Syntax(token, fmt::format("a value is expected before '{}'", token.text), std::move(hint));
}

Error Unexpected(std::span<const Token> tokens, std::size_t at, const SymbolTable& names) {
  const Token& token = tokens[at];
  const Token& before = tokens[at - 1];  // exists, because an operand precedes `token`
  if (token.kind != Token::Kind::kSign || token.text == "(" || token.text == "!") {
    return Syntax(token, fmt::format("an operator is missing before {}", Quoted(token)),
                  token.text == "!" || token.text == "(" || token.IsName("not")
                      ? std::string()
                      : OperatorHint(before, token, names));
  }
  if (token.text == "=") return Syntax(token, "'=' is not an operator", "write == to compare");
  if (token.text == "&") return Syntax(token, "'&' is not an operator", "write && or 'and'");
  if (token.text == "|") return Syntax(token, "'|' is not an operator", "write || or 'or'");
  if (token.text == "..") {
    return Syntax(token, "a range cannot be part of an expression",
                  "draw it as a separate parameter and use that parameter's name");
  }
  if (token.text == ",") {
    const bool decimal = before.kind == Token::Kind::kNumber && before.unit.empty() &&
                         tokens[at + 1].kind == Token::Kind::kNumber;
    return Syntax(token, "',' only separates the arguments of a function",
                  decimal ? fmt::format("write decimals with a point: {}.{}", before.text,
                                        tokens[at + 1].text)
                          : std::string());
  }
  if (token.text == ":") return Syntax(token, "':' has no '?' before it");
  if (token.text == "[") return Syntax(token, "only a list or a vector has items");
  if (token.text == "]") return Syntax(token, "']' has no '[' before it");
  return Syntax(token, fmt::format("'{}' has no '(' before it", token.text));
}

Error UnknownName(const Token& token, const SymbolTable& names, bool beside_text) {
  std::string usage(UsageOf(token.text));
  const SpecFunction* function = names.FindFunction(token.text);
  if (usage.empty() && function != nullptr) usage = function->Usage();
  if (usage.find('(') != usage.npos) {
    return Syntax(token, fmt::format("'{}' is a function", token.text),
                  fmt::format("write {}", usage));
  }
  std::string hint = ClosestName(token.text, names);
  if (beside_text && hint.empty()) hint = fmt::format("put text in quotes: '{}'", token.text);
  if (hint.empty() && FindUnitSuffix(token.text) != nullptr) {
    hint = fmt::format("a unit follows its number without a space: 1{}", token.text);
  }
  return {Code::kExprUnknownName, token.offset, fmt::format("unknown name '{}'", token.text),
          std::move(hint)};
}

Error NotAFunction(const Token& token, const SymbolTable& names) {
  if (names.Find(token.text) != nullptr) {
    return Syntax(token, fmt::format("'{}' is not a function", token.text),
                  fmt::format("write {} * (...)", token.text));
  }
  if (FindConstant(token.text) != nullptr) {
    return Syntax(token, fmt::format("'{}' is not a function", token.text));
  }
  std::vector<std::string_view> candidates;
  for (const BuiltinInfo& function : Builtins()) {
    if (FindBuiltin(function.name) != nullptr) candidates.push_back(function.name);
  }
  for (const auto& [name, function] : names.functions()) candidates.push_back(name);
  return {Code::kExprUnknownName, token.offset, fmt::format("unknown function '{}'", token.text),
          diag::DidYouMean(token.text, candidates)};
}

Error UnknownUnit(const Token& token, const SymbolTable& names) {
  const std::string_view digits = token.text.substr(0, token.text.size() - token.unit.size());
  std::string hint = diag::DidYouMean(token.unit, Units(), &Unit::name);
  if (names.Find(token.unit) != nullptr) hint = fmt::format("write {} * {}", digits, token.unit);
  if (hint.empty()) hint = "the units are " + diag::Joined(Units(), " ", &Unit::name);
  return {Code::kExprUnknownUnit, token.offset + digits.size(),
          fmt::format("unknown unit '{}'", token.unit), std::move(hint)};
}

Error WrongComponent(const Token& token, const SymbolTable::Variable& variable,
                     std::string_view component) {
  const std::string_view name = variable.name;
  if (variable.components == 1) {
    return WrongType(token, fmt::format("'{}' is a {}; it has no component '{}'", name,
                                        TypeName(variable.type), component));
  }
  return WrongType(
      token,
      fmt::format("'{}' is a vector of {} numbers; {}", name, variable.components,
                  component.empty() ? "an expression needs a single number"
                                    : fmt::format("it has no component '{}'", component)),
      fmt::format("use {}", ComponentList(variable)));
}

Error WholeList(const Token& token) {
  return WrongType(
      token, fmt::format("'{}' is a list; an expression needs a single value", token.text),
      fmt::format("write {0}[i], sum({0}), len({0}), min({0}) or max({0})", token.text));
}

Error ChainedComparison(std::string_view left, std::string_view middle, const Token& sign) {
  return Syntax(sign, "comparisons cannot be chained",
                fmt::format("write {} and {} {} ...", left, middle, sign.text));
}

Error NotAList(const Token& token, std::string_view usage) {
  return WrongType(token, fmt::format("'{}' is not the name of a list", token.text),
                   fmt::format("write {}", usage));
}

Error NotAName(const Token& token, std::string_view usage) {
  return Syntax(token, "a name is expected here", fmt::format("write {}", usage));
}

Error UnknownJoint(const Token& token, const SymbolTable& names) {
  std::vector<std::string_view> joints;
  for (const auto* variable : names.variables()) {
    const std::string_view name = variable->name;
    if (name.starts_with("torque(")) joints.push_back(name.substr(7, name.size() - 8));
  }
  std::string hint = diag::DidYouMean(token.text, joints);
  if (hint.empty()) {
    hint = joints.empty() ? "torques are known where all bodies are: in joints, `mjcf:`, `expect:`"
                          : "only hinges and ball joints of this spec have a torque";
  }
  return {Code::kExprUnknownName, token.offset,
          fmt::format("no torque of a joint '{}' is known here", token.text), std::move(hint)};
}

Error UnknownPoint(const Token& token, const SymbolTable& names) {
  std::vector<std::string_view> points;
  for (const auto* variable : names.variables()) {
    if (variable->components != 3) continue;
    std::string_view name = variable->name;
    if (name.ends_with(".pos")) name.remove_suffix(4);
    points.push_back(name);
  }
  std::string meant = diag::DidYouMean(token.text, points);
  if (meant.empty()) meant = "sites are known where all bodies are: in joints, `mjcf:`, `expect:`";
  return {Code::kExprUnknownName, token.offset,
          fmt::format("'{}' is neither a site nor a point of three numbers here", token.text),
          std::move(meant)};
}

Error NoSuchElement(const Token& token, double index, int count) {
  return {Code::kExprOutOfRange,
          token.offset,
          fmt::format("there is no {}[{}]: '{}' has {} values, counted from 0", token.text,
                      NumberText(index), token.text, count),
          {}};
}

Error MisusedText(const Token& token) {
  return WrongType(token,
                   fmt::format("'{}' is text; it can only be compared with == or !=", token.text));
}

Error TextAgainst(const Token& token) {
  return WrongType(token,
                   fmt::format("'{}' is text; it can only be compared with text", token.text));
}

Error TextBeside(const Token& token) {
  Error error = WrongType(
      token, fmt::format("'{}' is text; the other side of the choice is not", token.text));
  error.hint = "a text with numbers can be a value of `let:`, as in {above: \"link_${i - 1}\"}";
  return error;
}

Error WrongCount(const Token& function, int arity, int count, std::string_view usage) {
  return Syntax(
      function,
      fmt::format("'{}' takes {}{} argument{}, not {}", function.text,
                  arity == 0 ? "at least " : "", std::max(arity, 1), arity > 1 ? "s" : "", count),
      fmt::format("write {}", usage));
}

Error TooManyCalls(const Token& function, int limit) {
  return Syntax(function, fmt::format("the expression calls functions more than {} times", limit),
                std::string(kSplitHint));
}

Error TooDeep(const Token& token, int limit) {
  return Syntax(token, fmt::format("the expression is nested deeper than {} levels", limit),
                std::string(kSplitHint));
}

Error TooLong(std::size_t bytes, std::size_t limit) {
  return {Code::kExprSyntax, 0,
          fmt::format("the expression has {} bytes; the limit is {}", bytes, limit),
          std::string(kSplitHint)};
}

}  // namespace mjforge::expr
