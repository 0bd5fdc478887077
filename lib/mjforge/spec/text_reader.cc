// Functions of ValueReader that read texts, words, booleans and conditions.

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/spec/value_reader.h"

namespace mjforge::spec {

using diag::Code;
using expr::Type;

std::string_view Trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

std::vector<std::string_view> Split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> pieces;
  for (auto end = text.find(separator); end != text.npos; end = text.find(separator)) {
    pieces.push_back(text.substr(0, end));
    text.remove_prefix(end + separator.size());
  }
  pieces.push_back(text);
  return pieces;
}

Value ValueReader::ReadBoolean(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kMap)
    return ReadMapping({.kind = FieldKind::kBoolean}, node, {});
  if (node.kind != YamlNode::Kind::kScalar) return Wrong(node, "true or false");
  Value value{.mark = node.mark, .type = Type::kBoolean, .form = node.text == "true"};
  if (IsBooleanWord(node)) return value;
  if (names_.Find(node.text) == nullptr && expr::HasWord("yes no on off", node.text)) {
    findings_.Add(Code::kSpecWrongType, node.mark,
                  fmt::format("expected true or false, got the text '{}'", node.text),
                  "YAML 1.2 writes booleans as true and false");
    return value;
  }
  if (auto expression = ReadCondition(node)) value.form = std::move(*expression);
  return value;
}

std::optional<expr::Expression> ValueReader::ReadCondition(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kScalar) {
    Wrong(node, "a condition");
    return std::nullopt;
  }
  auto expression = Compile(node, 0, node.text.size());
  if (expression && expression->type() != Type::kBoolean) {
    findings_.Add(Code::kSpecWrongType, node.mark,
                  fmt::format("expected a condition, but '{}' is a number", node.text),
                  "compare it with something, as in `x > 0`");
    return std::nullopt;
  }
  return expression;
}

std::string ValueReader::ReadPlainText(std::string_view what, const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kScalar) {
    Wrong(node, fmt::format("text for '{}'", what));
    return {};
  }
  if (node.text.find("${") != std::string::npos) {
    findings_.Add(Code::kSpecWrongType, node.mark,
                  fmt::format("'{}' is fixed text: ${{...}} has no meaning in it", what));
    return {};
  }
  return node.text;
}

Value ValueReader::ReadText(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kMap) return ReadMapping({.kind = FieldKind::kText}, node, {});
  if (node.kind != YamlNode::Kind::kScalar) return Wrong(node, "text");
  Value value{.mark = node.mark, .type = Type::kText};
  Text text;
  std::size_t at = 0;
  while (at < node.text.size()) {
    const std::size_t open = std::min(node.text.find("${", at), node.text.size());
    if (open > at) text.pieces.push_back({.literal = node.text.substr(at, open - at)});
    if (open == node.text.size()) break;
    const std::size_t close = node.text.find('}', open);
    if (close == std::string::npos) {
      findings_.Add(Code::kExprSyntax, At(node.mark, open), "'${' without '}'");
      break;
    }
    const std::string_view inner = std::string_view(node.text).substr(open + 2, close - open - 2);
    const expr::SymbolTable::Variable* variable = names_.Find(Trim(inner));
    if (variable != nullptr && variable->type == Type::kText && !variable->is_list()) {
      uses_.AddName(variable->name);
      text.pieces.push_back(
          {.variable = VariableReference{.name = variable->name, .slot = variable->slot}});
    } else if (auto expression =
                   Compile(node, open + 2, close - open - 2, expr::Expression::Result::kAny)) {
      text.pieces.push_back({.expression = std::move(expression)});
    }
    at = close + 1;
  }
  value.form = std::move(text);
  return value;
}

Value ValueReader::ReadWord(const FieldInfo& expected, const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kMap) return ReadMapping(expected, node, {});
  Value value = ReadText(node);
  const auto* text = std::get_if<Text>(&value.form);
  if (text == nullptr || text->pieces.size() != 1 || text->pieces[0].literal.empty()) return value;
  const auto words = expr::WordsOf(expected.words);
  const std::string& word = text->pieces[0].literal;
  if (std::ranges::find(words, word) == words.end()) {
    std::string hint = diag::DidYouMean(word, words);
    if (names_.Find(word) != nullptr)
      hint = fmt::format("to use the parameter's value, write ${{{}}}", word);
    findings_.Add(Code::kSpecBadValue, node.mark,
                  fmt::format("'{}' is not one of {}", word, fmt::join(words, ", ")),
                  std::move(hint));
  }
  return value;
}

bool ValueReader::LooksLikeText(const YamlNode& node) const {
  const std::string_view text = node.text;
  if (IsQuotedNumber(node)) return true;
  const auto first = static_cast<unsigned char>(text.empty() ? '0' : text.front());
  if (std::isalpha(first) == 0 && first != '_' && first < 0x80 && first != '.') return false;
  const auto is_plain = [](char c) {
    return expr::IsNameCharacter(c) || c == '.' || c == '-' || c == '/' || c == ' ' ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  if (!std::ranges::all_of(text, is_plain)) return false;
  if (node.quoted && std::ranges::all_of(text, expr::IsNameCharacter)) return true;
  const auto used = expr::NamesUsedIn(text);
  return std::ranges::none_of(used,
                              [this](const std::string& name) { return names_.Find(name); }) &&
         (!used.empty() || text.find_first_of("-/ ") == std::string_view::npos);
}

}  // namespace mjforge::spec
