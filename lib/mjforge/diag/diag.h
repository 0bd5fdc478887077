// Findings (errors and warnings with their places in source files), and texts for messages:
// rendered findings, escaped text, suggestions for misspelled words.

#pragma once

// A finding describes what is wrong, where to correct it, and what was probably meant. Parsers,
// checks and other stages of the program add findings to a list and continue. Nothing in this
// library prints or exits.

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/codes.h"
#include "mjforge/diag/json.h"
#include "mjforge/diag/lists.h"

namespace mjforge::diag {

/// A place in a text of Sources. Lines and columns count from 1, columns in bytes. A
/// default-constructed mark refers to no place, and converts to false.
struct SourceMark {
  std::uint32_t file = 0;  // 1-based number in Sources
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  explicit operator bool() const { return file != 0; }
  auto operator<=>(const SourceMark&) const = default;
};

/// The texts that a run of the program has read. Marks are places in these texts, and rendered
/// findings quote lines of the texts.
class Sources {
 public:
  /// Adds a text and returns its number, which marks contain (SourceMark::file). `name` is the name
  /// of the text in messages. If a file is too long to be stored, `text` may be a piece of the file
  /// that begins at line `first_line`.
  std::uint32_t Add(std::string name, std::string text, std::uint32_t first_line = 1);

  const std::string& Name(std::uint32_t file) const { return files_[file - 1].name; }
  const std::string& Text(std::uint32_t file) const { return files_[file - 1].text; }
  /// Returns the line that contains the mark, without the line end; an empty text for a mark
  /// without a place.
  std::string_view Line(SourceMark mark) const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(files_.size()); }

 private:
  struct File {
    std::string name;
    std::string text;
    std::uint32_t first_line = 1;
    std::vector<std::size_t> line_starts = {};
  };
  std::vector<File> files_;
};

enum class Severity { kError, kWarning };

struct Note {
  SourceMark mark;
  std::string message;
};

struct Finding {
  Severity severity = Severity::kError;
  Code code = Code::kYamlSyntax;
  SourceMark mark = {};
  std::string message;           // a single line without a final full stop
  std::string hint = {};         // remedy; may be empty
  std::vector<Note> notes = {};  // related places
  // Seed of the variant; nullopt if the finding is about the spec.
  std::optional<std::uint64_t> seed = {};
  // Index of the variant; nullopt if the finding is about the spec.
  std::optional<std::uint64_t> index = {};
  /// Paths of files that are missing or wrong. A change of one of them may resolve the finding.
  std::vector<std::string> files = {};
};

class Findings {
 public:
  /// Adds a finding. The returned reference is valid until the list changes.
  Finding& Add(Finding finding) { return list_.emplace_back(std::move(finding)); }
  Finding& Add(Code code, SourceMark mark, std::string message, std::string hint = {});
  Finding& Warn(Code code, SourceMark mark, std::string message, std::string hint = {});
  /// Adds the error that a file cannot be read.
  Finding& AddCannotRead(std::string_view file, std::string_view why_not);
  void Append(Findings other);

  /// Returns the first error at position `first` of the list, or after it; null if there is none.
  const Finding* FirstError(std::size_t first = 0) const;
  bool HasErrors(std::size_t first = 0) const { return FirstError(first) != nullptr; }
  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  auto begin() { return list_.begin(); }
  auto end() { return list_.end(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  const Finding& operator[](std::size_t i) const { return list_[i]; }

  /// Sets the seed and the index of the variant in each finding that has neither.
  void SetVariant(std::uint64_t seed, std::uint64_t index);
  /// Sorts the findings by file, line and column. Findings at the same place remain in their order.
  void Sort();
  /// Keeps only the first of several findings with the same code, place and message.
  void Unique();
  /// Keeps only the first of more than `most` findings of one file with this code and the same
  /// message, and adds the number of the others to the message.
  void Fold(Code code, std::size_t most);
  void clear() { list_.clear(); }
  /// Keeps only the first `size` findings.
  void Truncate(std::size_t size) { list_.resize(std::min(size, list_.size())); }

 private:
  std::vector<Finding> list_;
};

/// Returns a finding as `file:line:col: error: message [code]`, the source line, a caret, the hint
/// and the notes. Every line ends with a newline. If `color` is true, the text contains ANSI color
/// sequences.
std::string RenderText(const Finding& finding, const Sources& sources, bool color);

/// Returns a finding as one JSON object without a line end. Its members are severity, code, file,
/// line, column, message, hint, seed, index and notes.
std::string RenderJson(const Finding& finding, const Sources& sources);

/// The first character of a text, decoded from UTF-8.
struct Utf8Char {
  char32_t value = 0;
  std::size_t length = 1;  // in bytes
  bool valid = false;      // false if the first bytes are not valid UTF-8
};
/// Decodes the first character of a text that is not empty.
Utf8Char DecodeUtf8(std::string_view text);
/// Returns true for a byte of UTF-8 that does not begin a character.
constexpr bool IsContinuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Returns text of unknown origin in a form that is safe to show on one line. Control characters,
/// line separators, bidirectional controls and invalid bytes are replaced by escapes ("\x1b"), so
/// that a spec cannot control a terminal or a page.
std::string SafeText(std::string_view text);

/// Returns a text of several lines in a safe form, like SafeText(), but with its line ends.
std::string SafeLines(std::string_view text);

/// Sets `why_not`, and returns nullopt, the result of a function that fails for this reason.
std::nullopt_t Refuse(std::string& why_not, std::string reason);

/// Returns the text before the first `separator`, and removes it and the separator from `text`; the
/// whole text if there is no separator.
std::string_view CutAt(char separator, std::string_view& text);

/// Returns a count with its noun, whose plural ends with "s": "1 number", "2 numbers".
std::string Counted(std::uint64_t count, std::string_view noun);
/// Returns a count with the singular or the plural of its noun: "1 body", "2 bodies".
std::string Counted(std::uint64_t count, std::string_view one, std::string_view many);

/// Returns the text with ASCII letters in lower case, regardless of the locale.
std::string LowerCase(std::string_view text);

/// Returns the candidate with the smallest edit distance to `word` (insertion, deletion,
/// replacement, swap of neighbours; ASCII case is ignored); if several are equally close, the one
/// that has most letters at its ends in common with `word`. Returns nullopt if the difference is
/// too large for a typing error.
std::optional<std::string_view> ClosestWord(std::string_view word,
                                            std::span<const std::string_view> candidates);

/// Returns "did you mean 'x'?" with the closest candidate; an empty text if no candidate is close.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates);
/// Returns "did you mean 'x'?" with the closest of the words in a list of any type; `name` is a
/// projection (a pointer to a member, for example) from an item of the list to its word.
template <typename List, typename Name = std::identity>
std::string DidYouMean(std::string_view word, const List& list, Name name = {}) {
  std::vector<std::string_view> candidates(std::size(list));
  std::ranges::transform(list, candidates.begin(), name);
  return DidYouMean(word, std::span<const std::string_view>(candidates));
}

/// Returns the message with "; did you mean 'x'?" if a word of the list is close to `word`.
template <typename List>
std::string WithSuggestion(std::string message, std::string_view word, const List& list) {
  const std::string meant = DidYouMean(word, list);
  return meant.empty() ? message : message + "; " + meant;
}

}  // namespace mjforge::diag
