// Reader of C++ comments: where each sentence begins and what it says first.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::house {

/// A sentence of a comment. Comments that continue from line to line are read as one text; an empty
/// comment line ends a sentence.
struct Sentence {
  std::size_t line = 0;  // from 1
  std::string text;      // without slashes, its words separated by single spaces
};

/// All sentences of the `//` and `///` comments of a C++ file, in order.
std::vector<Sentence> ReadSentences(std::string_view text);

}  // namespace mjforge::house
