// Tokenizer of expressions.
#include "mjforge/expr/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mjforge/expr/builtins.h"

namespace mjforge::expr {
namespace {

// Signs of expressions. A longer sign comes before the signs with which it begins (`<=` before
// `<`), because the first match is taken. `=`, `&`, `|` and `..` are not valid in expressions, but
// they are tokens, so that the parser can name them in its errors.
constexpr std::array<std::string_view, 26> kSigns = {
    "..", "<=", ">=", "==", "!=", "&&", "||", "+", "-", "*", "/", "^", "%",
    "(",  ")",  "[",  "]",  ",",  "?",  ":",  "<", ">", "!", "=", "&", "|"};

bool IsHexDigit(char c) { return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Tokenizer {
 public:
  Tokenizer(std::string_view text, std::vector<Token>& tokens, Error& error)
      : text_(text), tokens_(tokens), error_(error) {}

  bool Run() {
    for (;;) {
      while (IsBlank(Peek())) ++at_;
      if (at_ == text_.size()) break;
      if (!ReadToken()) return false;
    }
    tokens_.push_back({.kind = Token::Kind::kEnd, .offset = at_});
    return true;
  }

 private:
  // Returns the character `ahead` places after the current one; '\0', which belongs to no token,
  // past the end of the text.
  char Peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  template <typename Predicate>
  void Skip(Predicate predicate) {
    while (at_ < text_.size() && predicate(text_[at_])) ++at_;
  }

  std::string_view Since(std::size_t begin) const { return text_.substr(begin, at_ - begin); }

  bool Fail(std::size_t offset, std::string message, std::string hint = {}) {
    error_ = {diag::Code::kExprSyntax, offset, std::move(message), std::move(hint)};
    return false;
  }

  bool ReadToken() {
    if (IsDigit(Peek()) || (Peek() == '.' && IsDigit(Peek(1)))) return Number();
    if (IsLetter(Peek())) return Name();
    if (Peek() == '\'' || Peek() == '"') return Text();
    for (const std::string_view sign : kSigns) {
      if (text_.substr(at_).starts_with(sign)) {
        tokens_.push_back({.kind = Token::Kind::kSign, .offset = at_, .text = sign});
        at_ += sign.size();
        return true;
      }
    }
    return FailCharacter();
  }

  // Skips a decimal number. A point belongs to the number unless a second point follows (`1..2` is
  // a range).
  void SkipDecimal() {
    Skip(IsDigit);
    if (Peek() == '.' && Peek(1) != '.') {
      ++at_;
      Skip(IsDigit);
    }
    const std::size_t sign = Peek(1) == '+' || Peek(1) == '-' ? 1 : 0;
    if ((Peek() == 'e' || Peek() == 'E') && IsDigit(Peek(1 + sign))) {
      at_ += 1 + sign;
      Skip(IsDigit);
    }
  }

  bool Number() {
    const std::size_t begin = at_;
    if (Peek() == '0' && Peek(1) == 'x' && IsHexDigit(Peek(2))) {
      at_ += 2;
      Skip(IsHexDigit);
    } else if (Peek() == '0' && Peek(1) == 'o' && IsDigit(Peek(2))) {
      at_ += 2;
      Skip(IsDigit);
    } else {
      SkipDecimal();
    }
    const std::string_view digits = Since(begin);
    const std::size_t unit = at_;
    Skip(IsNameCharacter);
    if (Peek() == '.' && Peek(1) != '.') {
      Skip([](char c) { return IsNameCharacter(c) || c == '.'; });
      return Fail(begin, fmt::format("'{}' is not a number", Since(begin)));
    }
    const std::optional<double> number = ParseNumber(digits);
    if (!number) {
      const bool octal = digits.find_first_of("89") != digits.npos && digits.starts_with("0o");
      return Fail(begin, fmt::format("'{}' is {}", digits,
                                     octal ? "not an octal number"
                                           : "too large or too small for a number"));
    }
    tokens_.push_back({Token::Kind::kNumber, begin, Since(begin), *number, Since(unit)});
    return true;
  }

  bool Name() {
    const std::size_t begin = at_;
    Skip(IsNameCharacter);
    while (Peek() == '.' && IsLetter(Peek(1))) {
      ++at_;
      Skip(IsNameCharacter);
    }
    tokens_.push_back({.kind = Token::Kind::kName, .offset = begin, .text = Since(begin)});
    return true;
  }

  bool Text() {
    const std::size_t begin = at_;
    const std::size_t end = text_.find(Peek(), begin + 1);
    if (end == std::string_view::npos) return Fail(begin, "the quote is not closed");
    tokens_.push_back({.kind = Token::Kind::kText,
                       .offset = begin,
                       .text = text_.substr(begin + 1, end - begin - 1)});
    at_ = end + 1;
    return true;
  }

  bool FailCharacter() {
    const std::size_t begin = at_++;
    Skip(diag::IsContinuation);
    const std::string_view character = Since(begin);
    std::string hint;
    if (character == "$") hint = "inside an expression write only the name, without ${}";
    if (character == "{") hint = "an expression gives one value, not a list";
    if (character == "×" || character == "·") hint = "write * to multiply";
    if (character == "÷") hint = "write / to divide";
    if (character == "−" || character == "–") hint = "write the ASCII minus sign -";
    if (character == "°") hint = "write deg after the number";
    return Fail(begin, fmt::format("unexpected character '{}'", character), std::move(hint));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Token>& tokens_;
  Error& error_;
};

}  // namespace

bool Tokenize(std::string_view text, std::vector<Token>& tokens, Error& error) {
  return Tokenizer(text, tokens, error).Run();
}

bool IsReserved(std::string_view name) {
  return name == "and" || name == "or" || name == "not" || FindBuiltin(name) != nullptr ||
         FindConstant(name) != nullptr;
}

std::vector<std::string> NamesUsedIn(std::string_view text) {
  std::vector<Token> tokens;
  Error error;
  std::vector<std::string> names;
  if (!Tokenize(text, tokens, error)) return names;
  for (const Token& token : tokens) {
    if (token.kind != Token::Kind::kName) continue;
    if (IsReserved(token.text)) continue;
    const std::size_t dot = token.text.rfind('.');
    const bool has_component = dot != std::string_view::npos && dot + 2 == token.text.size() &&
                               kComponents.find(token.text.back()) != std::string_view::npos;
    std::string name(has_component ? token.text.substr(0, dot) : token.text);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace mjforge::expr
