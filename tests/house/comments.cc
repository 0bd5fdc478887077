// Reader of C++ comments.

#include "house/comments.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

// Finds the comment in each line of a file, in turn. A raw string may span several lines.
class CommentFinder {
 public:
  /// Returns the position of the comment's two slashes, or npos.
  std::size_t FindIn(std::string_view line) {
    for (std::size_t at = 0; at < line.size();) {
      if (!raw_end_.empty()) {
        at = End(line, at);
      } else if (line.substr(at).starts_with("//")) {
        return at;
      } else if (line.substr(at).starts_with("R\"")) {
        raw_end_ = ")" + std::string(line.substr(at + 2, line.find('(', at) - at - 2)) + "\"";
        at += 2;
      } else {
        at = line[at] == '"' || IsCharacter(line, at) ? AfterQuoted(line, at) : at + 1;
      }
    }
    return std::string_view::npos;
  }

 private:
  // Returns the position after the end of the raw string, or the end of the line.
  std::size_t End(std::string_view line, std::size_t at) {
    const std::size_t end = line.find(raw_end_, at);
    if (end == std::string_view::npos) return line.size();
    return end + std::exchange(raw_end_, {}).size();
  }

  // Returns false for the separator in 1'000'000.
  static bool IsCharacter(std::string_view line, std::size_t at) {
    return line[at] == '\'' &&
           (at == 0 || std::isalnum(static_cast<unsigned char>(line[at - 1])) == 0);
  }

  static std::size_t AfterQuoted(std::string_view line, std::size_t at) {
    const char quote = line[at];
    for (++at; at < line.size() && line[at] != quote; ++at) at += line[at] == '\\' ? 1 : 0;
    return at + 1;
  }

  std::string raw_end_;  // what ends the raw string that is open; empty: none is
};

std::vector<std::string_view> Words(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string_view::npos;) {
    words.push_back(text.substr(at, text.find(' ', at) - at));
    at += words.back().size();
  }
  return words;
}

// Returns true if `last` ends a sentence that `next` follows.
bool IsEnd(std::string_view last, std::string_view next) {
  const std::size_t mark = last.find_last_not_of(")\"`");
  return mark != std::string_view::npos && (last[mark] == '.' || last[mark] == '?') &&
         std::isupper(static_cast<unsigned char>(next.front())) != 0;
}

}  // namespace

std::vector<Sentence> ReadSentences(std::string_view text) {
  std::vector<Sentence> sentences;
  CommentFinder finder;
  std::size_t number = 0;
  std::size_t column = std::string_view::npos;  // of the comment in the line above
  std::string_view last;                        // word; empty: the next one begins a sentence
  for (const std::string_view line : Lines(text)) {
    ++number;
    const std::size_t at = finder.FindIn(line);
    const bool is_alone = line.find_first_not_of(' ') == at;
    if (at == std::string_view::npos || !is_alone || at != column) last = {};
    column = at;
    if (at == std::string_view::npos) continue;
    const std::vector<std::string_view> words =
        Words(line.substr(std::min(line.find_first_not_of('/', at), line.size())));
    if (words.empty()) last = {};
    for (const std::string_view word : words) {
      if (last.empty() || IsEnd(last, word)) sentences.push_back({number, ""});
      std::string& sentence = sentences.back().text;
      if (!sentence.empty()) sentence += ' ';
      sentence += word;
      last = word;
    }
  }
  return sentences;
}

}  // namespace mjforge::house
