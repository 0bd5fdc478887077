#pragma once

// Private to the room: where one is in the words of an expression.

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/expr/words.h"

namespace mjforge::expr {

class Cursor {
 protected:
  Cursor(std::string_view text, std::vector<Word> words) : words_(std::move(words)), text_(text) {}

  const Word& Now() const { return words_[at_]; }

  bool Take(std::string_view sign) {
    if (!Now().IsSign(sign)) return false;
    ++at_;
    return true;
  }

  bool AtComparison() const {
    static constexpr std::array<std::string_view, 6> kSigns = {"<", "<=", ">", ">=", "==", "!="};
    return Now().kind == Word::Kind::kSign &&
           std::find(kSigns.begin(), kSigns.end(), Now().text) != kSigns.end();
  }

  // What is written from one word up to another.
  std::string_view Source(std::size_t begin, std::size_t end) const {
    const std::size_t from = words_[begin].offset;
    std::string_view source = text_.substr(from, words_[end].offset - from);
    while (source.ends_with(' ') || source.ends_with('\n')) source.remove_suffix(1);
    return source;
  }

  std::vector<Word> words_;
  std::size_t at_ = 0;

 private:
  std::string_view text_;
};

}  // namespace mjforge::expr
