#include "mjforge/expr/complaints.h"

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/expr/functions.h"

namespace mjforge::expr {
namespace {

using diag::Code;

bool IsUnit(std::string_view name) {
  const auto units = Units();
  return std::any_of(units.begin(), units.end(), [name](const Unit& u) { return u.name == name; });
}

std::string Shown(const Word& word) {
  return word.kind == Word::Kind::kText ? fmt::format("the text '{}'", word.text)
                                        : fmt::format("'{}'", word.text);
}

std::string OperatorHint(const Word& before, const Word& word, const Names& names) {
  if (word.kind == Word::Kind::kName && IsUnit(word.text) && names.Find(word.text) == nullptr) {
    if (before.kind == Word::Kind::kNumber && before.unit.empty()) {
      return fmt::format("a unit follows its number without a space: {}{}", before.text, word.text);
    }
    return fmt::format("only numbers carry units: multiply by 1{}", word.text);
  }
  const bool factor = before.kind == Word::Kind::kNumber || before.kind == Word::Kind::kName;
  if (!factor || word.kind != Word::Kind::kName) return {};
  return fmt::format("write {} * {}", before.text, word.text);
}

std::string ClosestName(std::string_view word, const Names& names) {
  std::vector<std::string_view> candidates;
  for (const auto* variable : names.variables()) candidates.push_back(variable->name);
  for (const Function& function : Functions()) candidates.push_back(function.name);
  for (const auto& [name, formula] : names.formulas()) candidates.push_back(name);
  return diag::DidYouMean(word, candidates);
}

std::string ComponentList(const Names::Variable& variable) {
  static constexpr std::string_view kLetters = "xyzw";
  const std::size_t count = std::min<std::size_t>(static_cast<std::size_t>(variable.components), 4);
  std::string list;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) list += i + 1 == count ? " or " : ", ";
    list += fmt::format("{}.{}", variable.name, kLetters[i]);
  }
  return list;
}

Error Syntax(const Word& word, std::string message, std::string hint = {}) {
  return {Code::kExprSyntax, word.offset, std::move(message), std::move(hint)};
}

}  // namespace

Error MissingValue(std::span<const Word> words, std::size_t at) {
  const Word& word = words[at];
  if (word.kind == Word::Kind::kEnd) {
    return at == 0 ? Syntax(word, "the expression is empty")
                   : Syntax(word, "the expression ends where a value is expected");
  }
  if (word.IsName("not")) {
    return Syntax(word, "'not' binds more loosely than what precedes it",
                  "put it in parentheses: (not ...)");
  }
  const Word* before = at > 0 ? &words[at - 1] : nullptr;
  const bool adjacent = before && before->offset + before->text.size() == word.offset;
  std::string hint;
  if (adjacent && word.IsSign("*") && before->IsSign("*")) hint = "write ^ for a power";
  if (word.IsSign("[")) hint = "an expression gives one value, not a list";
  if (adjacent && word.IsSign("=") && !before->IsSign("(")) {
    hint = "the comparisons are == != < <= > >=";
  }
  return Syntax(word, fmt::format("a value is expected before '{}'", word.text), std::move(hint));
}

Error Unexpected(std::span<const Word> words, std::size_t at, const Names& names) {
  const Word& word = words[at];
  const Word& before = words[at - 1];  // something could be read, so there is one
  if (word.kind != Word::Kind::kSign || word.text == "(" || word.text == "!") {
    return Syntax(word, fmt::format("an operator is missing before {}", Shown(word)),
                  word.text == "!" || word.text == "(" || word.IsName("not")
                      ? std::string()
                      : OperatorHint(before, word, names));
  }
  if (word.text == "=") return Syntax(word, "'=' is not an operator", "write == to compare");
  if (word.text == "&") return Syntax(word, "'&' is not an operator", "write && or 'and'");
  if (word.text == "|") return Syntax(word, "'|' is not an operator", "write || or 'or'");
  if (word.text == "..") {
    return Syntax(word, "a range cannot be part of an expression",
                  "draw it as a separate parameter and use that parameter's name");
  }
  if (word.text == ",") {
    const bool decimal = before.kind == Word::Kind::kNumber && before.unit.empty() &&
                         words[at + 1].kind == Word::Kind::kNumber;
    return Syntax(
        word, "',' only separates the arguments of a function",
        decimal ? fmt::format("write decimals with a point: {}.{}", before.text, words[at + 1].text)
                : std::string());
  }
  if (word.text == ":") return Syntax(word, "':' has no '?' before it");
  if (word.text == "[") return Syntax(word, "only a list or a vector has items");
  if (word.text == "]") return Syntax(word, "']' has no '[' before it");
  return Syntax(word, fmt::format("'{}' has no '(' before it", word.text));
}

Error UnknownName(const Word& word, const Names& names, bool beside_text) {
  if (FindCallee(word.text) != nullptr) {
    return Syntax(word, fmt::format("'{}' is a function", word.text),
                  fmt::format("write {}", UsageOf(word.text)));
  }
  if (const Formula* formula = names.FindFormula(word.text)) {
    return Syntax(word, fmt::format("'{}' is a function", word.text),
                  fmt::format("write {}", formula->Usage()));
  }
  std::string hint = ClosestName(word.text, names);
  if (beside_text && hint.empty()) hint = fmt::format("put text in quotes: '{}'", word.text);
  if (hint.empty() && IsUnit(word.text)) {
    hint = fmt::format("a unit follows its number without a space: 1{}", word.text);
  }
  return {Code::kExprUnknownName, word.offset, fmt::format("unknown name '{}'", word.text),
          std::move(hint)};
}

Error NotAFunction(const Word& word, const Names& names) {
  if (names.Find(word.text) != nullptr) {
    return Syntax(word, fmt::format("'{}' is not a function", word.text),
                  fmt::format("write {} * (...)", word.text));
  }
  if (FindConstant(word.text) != nullptr) {
    return Syntax(word, fmt::format("'{}' is not a function", word.text));
  }
  std::vector<std::string_view> candidates;
  for (const Function& function : Functions()) {
    if (FindCallee(function.name) != nullptr) candidates.push_back(function.name);
  }
  for (const auto& [name, formula] : names.formulas()) candidates.push_back(name);
  return {Code::kExprUnknownName, word.offset, fmt::format("unknown function '{}'", word.text),
          diag::DidYouMean(word.text, candidates)};
}

Error UnknownUnit(const Word& word, const Names& names) {
  std::vector<std::string_view> candidates;
  std::string list;
  for (const Unit& unit : Units()) {
    candidates.push_back(unit.name);
    list += fmt::format(" {}", unit.name);
  }
  const std::string_view digits = word.text.substr(0, word.text.size() - word.unit.size());
  std::string hint = diag::DidYouMean(word.unit, candidates);
  if (names.Find(word.unit) != nullptr) hint = fmt::format("write {} * {}", digits, word.unit);
  if (hint.empty()) hint = fmt::format("the units are{}", list);
  return {Code::kExprUnknownUnit, word.offset + digits.size(),
          fmt::format("unknown unit '{}'", word.unit), std::move(hint)};
}

Error WrongComponent(const Word& word, const Names::Variable& variable,
                     std::string_view component) {
  const std::string name = variable.name;
  if (variable.components == 1) {
    return {Code::kExprType,
            word.offset,
            fmt::format("'{}' is a {}; it has no component '{}'", name, TypeName(variable.type),
                        component),
            {}};
  }
  std::string message =
      component.empty()
          ? fmt::format("'{}' is a vector of {} numbers; an expression needs a single number", name,
                        variable.components)
          : fmt::format("'{}' is a vector of {} numbers; it has no component '{}'", name,
                        variable.components, component);
  return {Code::kExprType, word.offset, std::move(message),
          fmt::format("use {}", ComponentList(variable))};
}

Error WholeList(const Word& word) {
  const std::string_view name = word.text;
  return {Code::kExprType, word.offset,
          fmt::format("'{}' is a list; an expression needs a single value", name),
          fmt::format("write {0}[i], sum({0}), len({0}), min({0}) or max({0})", name)};
}

Error NotAList(const Word& word, std::string_view usage) {
  return {Code::kExprType, word.offset, fmt::format("'{}' is not the name of a list", word.text),
          fmt::format("write {}", usage)};
}

Error NoSuchElement(const Word& word, double index, int count) {
  return {Code::kExprOutOfRange,
          word.offset,
          fmt::format("there is no {}[{}]: '{}' has {} values, counted from 0", word.text,
                      NumberText(index), word.text, count),
          {}};
}

Error MisusedText(const Word& word) {
  return {Code::kExprType,
          word.offset,
          fmt::format("'{}' is text; it can only be compared with == or !=", word.text),
          {}};
}

Error TextAgainst(const Word& word) {
  return {Code::kExprType,
          word.offset,
          fmt::format("'{}' is text; it can only be compared with text", word.text),
          {}};
}

Error TextBeside(const Word& word) {
  return {Code::kExprType,
          word.offset,
          fmt::format("'{}' is text; the other side of the choice is not", word.text),
          {}};
}

Error WrongCount(const Word& function, int arity, int count, std::string_view usage) {
  return Syntax(
      function,
      fmt::format("'{}' takes {}{} argument{}, not {}", function.text,
                  arity == 0 ? "at least " : "", std::max(arity, 1), arity > 1 ? "s" : "", count),
      fmt::format("write {}", usage));
}

Error TooManyCalls(const Word& function, int limit) {
  return Syntax(function, fmt::format("the expression calls functions more than {} times", limit),
                std::string(kSplitHint));
}

Error TooDeep(const Word& word, int limit) {
  return Syntax(word, fmt::format("the expression is nested deeper than {} levels", limit),
                std::string(kSplitHint));
}

Error TooLong(std::size_t bytes, std::size_t limit) {
  return {Code::kExprSyntax, 0,
          fmt::format("the expression has {} bytes; the limit is {}", bytes, limit),
          std::string(kSplitHint)};
}

}  // namespace mjforge::expr
