// Cursor that moves through the tokens of an expression. Private to lib/mjforge/expr.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/expr/tokens.h"

namespace mjforge::expr {

class TokenCursor {
 protected:
  TokenCursor(std::string_view text, std::vector<Token> tokens)
      : tokens_(std::move(tokens)), text_(text) {}

  const Token& Now() const { return tokens_[at_]; }

  bool Take(std::string_view sign) {
    if (!Now().IsSign(sign)) return false;
    ++at_;
    return true;
  }

  bool AtComparison() const {
    static constexpr std::array<std::string_view, 6> kSigns = {"<", "<=", ">", ">=", "==", "!="};
    return Now().kind == Token::Kind::kSign &&
           std::find(kSigns.begin(), kSigns.end(), Now().text) != kSigns.end();
  }

  // Returns the source text from the start of token `begin` to the start of token `end`, without
  // blanks at its end.
  std::string_view Source(std::size_t begin, std::size_t end) const {
    const std::size_t from = tokens_[begin].offset;
    std::string_view source = text_.substr(from, tokens_[end].offset - from);
    while (source.ends_with(' ') || source.ends_with('\n')) source.remove_suffix(1);
    return source;
  }

  std::vector<Token> tokens_;
  std::size_t at_ = 0;

 private:
  std::string_view text_;
};

}  // namespace mjforge::expr
