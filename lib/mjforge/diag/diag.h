#pragma once

// Findings: what is wrong, where the user can fix it, what was probably meant. Stages add findings
// to a list and continue; nothing here prints or exits.

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/codes.h"
#include "mjforge/diag/json.h"

namespace mjforge::diag {

/// A place in a text of a `Sources`. Line and column count from 1, columns in
/// bytes. A default mark means "no place".
struct SourceMark {
  std::uint32_t file = 0;  // 1-based number in Sources
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  explicit operator bool() const { return file != 0; }
  auto operator<=>(const SourceMark&) const = default;
};

/// The texts read in a run: marks point into them, findings quote them.
class Sources {
 public:
  /// `name` is shown to the user unchanged. Returns the number for marks. If a file is too long to
  /// keep, `text` may be only a piece of it that begins at line `first_line`.
  std::uint32_t Add(std::string name, std::string text, std::uint32_t first_line = 1);

  const std::string& Name(std::uint32_t file) const { return files_[file - 1].name; }
  const std::string& Text(std::uint32_t file) const { return files_[file - 1].text; }
  /// The line a mark points into, without its end; empty for "no place".
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
  SourceMark mark;
  std::string message;                 // one line, no final stop
  std::string hint;                    // what to do about it; may be empty
  std::vector<Note> notes;             // further places
  std::optional<std::uint64_t> seed;   // from sampling on
  std::optional<std::uint64_t> index;  // from sampling on
};

class Findings {
 public:
  /// The reference is valid until the next Add.
  Finding& Add(Finding finding) { return list_.emplace_back(std::move(finding)); }
  Finding& Add(Code code, SourceMark mark, std::string message, std::string hint = {});
  Finding& Warn(Code code, SourceMark mark, std::string message, std::string hint = {});
  void Append(Findings other);

  bool HasErrors() const;
  bool empty() const { return list_.empty(); }
  std::size_t size() const { return list_.size(); }
  auto begin() { return list_.begin(); }
  auto end() { return list_.end(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  const Finding& operator[](std::size_t i) const { return list_[i]; }

  /// Sets the seed and index of every finding that has none yet.
  void SetVariant(std::uint64_t seed, std::uint64_t index);
  /// Sorts by file, line and column; findings at the same place keep their order.
  void Sort();
  /// Drops repeats (same code, place and message), keeping the first.
  void Unique();
  void clear() { list_.clear(); }

 private:
  std::vector<Finding> list_;
};

/// `file:line:col: error: message [code]`, the line, a caret, hint and notes; every line ends with
/// a newline. With color, ANSI sequences.
std::string RenderText(const Finding& finding, const Sources& sources, bool color);

/// One JSON object without a line end: severity code file line column message
/// hint seed index notes[].
std::string RenderJson(const Finding& finding, const Sources& sources);

/// The first character of a text.
struct Utf8Char {
  char32_t value = 0;
  std::size_t length = 1;  // in bytes
  bool valid = false;      // false: the first byte is not UTF-8
};
/// Decodes the first character of a text that is not empty.
Utf8Char DecodeUtf8(std::string_view text);

/// Makes text of unknown origin safe to show on one line. Control characters, invalid bytes and the
/// marks that turn the direction of writing are spelled out ("\x1b"): a spec must not be able to
/// steer a terminal or a page.
std::string SafeText(std::string_view text);

/// With ASCII's letters in lower case, whatever the locale.
std::string LowerCase(std::string_view text);

/// The candidate nearest to `word` by edit distance (insert, delete, replace, swap of neighbours),
/// if it is near enough to be a typing error; ties go to the first.
std::optional<std::string_view> ClosestWord(std::string_view word,
                                            std::span<const std::string_view> candidates);

/// "did you mean 'x'?" or nothing.
std::string DidYouMean(std::string_view word, std::span<const std::string_view> candidates);
/// The same for any list of candidates; `name` is the member of each that holds its name.
template <typename List, typename Name = std::identity>
std::string DidYouMean(std::string_view word, const List& list, Name name = {}) {
  std::vector<std::string_view> candidates;
  for (const auto& candidate : list) candidates.push_back(std::invoke(name, candidate));
  return DidYouMean(word, std::span<const std::string_view>(candidates));
}

}  // namespace mjforge::diag
