#include "mjforge/expr/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mjforge/expr/functions.h"

namespace mjforge::expr {
namespace {

// Longer ones first. `=`, `&`, `|` and `..` mean nothing in an expression, but
// the grammar has something to say about them.
constexpr std::array<std::string_view, 26> kSigns = {
    "..", "<=", ">=", "==", "!=", "&&", "||", "+", "-", "*", "/", "^", "%",
    "(",  ")",  "[",  "]",  ",",  "?",  ":",  "<", ">", "!", "=", "&", "|"};

bool IsHexDigit(char c) { return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

class Splitter {
 public:
  Splitter(std::string_view text, std::vector<Word>& words, Error& error)
      : text_(text), words_(words), error_(error) {}

  bool Run() {
    for (;;) {
      while (IsBlank(Peek())) ++at_;
      if (at_ == text_.size()) break;
      if (!One()) return false;
    }
    words_.push_back({.kind = Word::Kind::kEnd, .offset = at_});
    return true;
  }

 private:
  // '\0' past the end; it is no part of any word.
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

  bool One() {
    if (IsDigit(Peek()) || (Peek() == '.' && IsDigit(Peek(1)))) return Number();
    if (IsLetter(Peek())) return Name();
    if (Peek() == '\'' || Peek() == '"') return Text();
    for (const std::string_view sign : kSigns) {
      if (text_.substr(at_).starts_with(sign)) {
        words_.push_back({.kind = Word::Kind::kSign, .offset = at_, .text = sign});
        at_ += sign.size();
        return true;
      }
    }
    return Stranger();
  }

  // A dot belongs to the number unless another follows: `1..2` is a range.
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
    words_.push_back({Word::Kind::kNumber, begin, Since(begin), *number, Since(unit)});
    return true;
  }

  bool Name() {
    const std::size_t begin = at_;
    Skip(IsNameCharacter);
    while (Peek() == '.' && IsLetter(Peek(1))) {
      ++at_;
      Skip(IsNameCharacter);
    }
    words_.push_back({.kind = Word::Kind::kName, .offset = begin, .text = Since(begin)});
    return true;
  }

  bool Text() {
    const std::size_t begin = at_;
    const std::size_t end = text_.find(Peek(), begin + 1);
    if (end == std::string_view::npos) return Fail(begin, "the quote is not closed");
    words_.push_back({.kind = Word::Kind::kText,
                      .offset = begin,
                      .text = text_.substr(begin + 1, end - begin - 1)});
    at_ = end + 1;
    return true;
  }

  bool Stranger() {
    const std::size_t begin = at_++;
    Skip([](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; });
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
  std::vector<Word>& words_;
  Error& error_;
};

bool IsComponent(std::string_view part) {
  return part == "x" || part == "y" || part == "z" || part == "w";
}

}  // namespace

bool SplitWords(std::string_view text, std::vector<Word>& words, Error& error) {
  return Splitter(text, words, error).Run();
}

bool IsReserved(std::string_view name) {
  return name == "and" || name == "or" || name == "not" || FindCallee(name) != nullptr ||
         FindConstant(name) != nullptr;
}

std::vector<std::string> NamesUsedIn(std::string_view text) {
  std::vector<Word> words;
  Error error;
  std::vector<std::string> names;
  if (!SplitWords(text, words, error)) return names;
  for (const Word& word : words) {
    if (word.kind != Word::Kind::kName) continue;
    if (IsReserved(word.text)) continue;
    const std::size_t dot = word.text.rfind('.');
    const bool component = dot != std::string_view::npos && IsComponent(word.text.substr(dot + 1));
    std::string name(component ? word.text.substr(0, dot) : word.text);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace mjforge::expr
