// Findings as text for a terminal: place, message, quoted line with a caret, hint, notes.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "mjforge/diag/diag.h"
#include "mjforge/diag/utf8.h"

namespace mjforge::diag {
namespace {

constexpr int kLineColumns = 120;
// Maximum number of bytes that are decoded on each side of the caret: enough for a line of output.
// Without this limit, a line of 100 MB would be decoded as a whole.
constexpr std::size_t kWindowBytes = 1024;
constexpr std::string_view kDots = "...";

constexpr std::string_view kBold = "\x1b[1m";
constexpr std::string_view kRed = "\x1b[1;31m";
constexpr std::string_view kYellow = "\x1b[1;33m";
constexpr std::string_view kGreen = "\x1b[1;32m";
constexpr std::string_view kReset = "\x1b[0m";

std::string Painted(std::string_view text, std::string_view paint, bool color) {
  return color ? fmt::format("{}{}{}", paint, text, kReset) : std::string(text);
}

// The part of a source line around the caret, as terminal cells (one per character).
struct Excerpt {
  std::vector<TerminalCell> cells;
  // Index of the cell above the caret; cells.size() if the caret is after the last cell.
  std::size_t caret = 0;
  bool cut_front = false;
  bool cut_back = false;
};

Excerpt SplitLine(std::string_view line, std::size_t caret_byte) {
  Excerpt excerpt;
  std::size_t begin = caret_byte > kWindowBytes ? caret_byte - kWindowBytes : 0;
  while (begin > 0 && begin < line.size() && IsContinuation(line[begin])) --begin;
  const std::size_t end = std::min(line.size(), caret_byte + kWindowBytes);
  excerpt.cut_front = begin > 0;
  excerpt.cut_back = end < line.size();
  for (std::size_t i = begin; i < end;) {
    const std::string_view rest = line.substr(i);
    const Utf8Char character = DecodeUtf8(rest);
    if (i <= caret_byte) excerpt.caret = excerpt.cells.size();
    excerpt.cells.push_back(rest[0] == '\t' ? TerminalCell{" ", 1} : SafeCell(rest, character));
    i += character.length;
  }
  if (caret_byte >= line.size()) excerpt.caret = excerpt.cells.size();
  return excerpt;
}

int WidthOf(const Excerpt& excerpt, std::size_t begin, std::size_t end) {
  int width = 0;
  for (std::size_t i = begin; i < end; ++i) width += excerpt.cells[i].width;
  return width;
}

// Removes the characters that are farthest from the caret, so that the excerpt fits into a line of
// output with "..." at both ends. Does nothing if the whole source line fits.
void Fit(Excerpt& excerpt) {
  const std::size_t count = excerpt.cells.size();
  if (!excerpt.cut_front && !excerpt.cut_back && WidthOf(excerpt, 0, count) <= kLineColumns) return;
  const int room = kLineColumns - 2 * static_cast<int>(kDots.size());
  std::size_t begin = excerpt.caret;
  std::size_t end = std::min(count, excerpt.caret + 1);
  int width = WidthOf(excerpt, begin, end);
  for (bool grown = true; grown;) {
    grown = false;
    if (begin > 0 && width + excerpt.cells[begin - 1].width <= room) {
      width += excerpt.cells[--begin].width;
      grown = true;
    }
    if (end < count && width + excerpt.cells[end].width <= room) {
      width += excerpt.cells[end++].width;
      grown = true;
    }
  }
  excerpt.cut_front = excerpt.cut_front || begin > 0;
  excerpt.cut_back = excerpt.cut_back || end < count;
  const auto first = excerpt.cells.begin();
  excerpt.cells = std::vector<TerminalCell>(first + static_cast<std::ptrdiff_t>(begin),
                                            first + static_cast<std::ptrdiff_t>(end));
  excerpt.caret -= begin;
}

// Returns two lines of text: the source line (or an excerpt) that contains the mark, and a caret
// below the mark. Returns an empty text for a blank source line.
std::string Quote(SourceMark mark, const Sources& sources, bool color) {
  const std::string_view line = sources.Line(mark);
  if (line.find_first_not_of(" \t") == std::string_view::npos) return {};
  const std::size_t column = mark.column == 0 ? 0 : mark.column - 1;
  Excerpt excerpt = SplitLine(line, std::min<std::size_t>(column, line.size()));
  Fit(excerpt);
  std::string text(excerpt.cut_front ? kDots : "");
  std::string indent(text.size(), ' ');
  for (const TerminalCell& cell : excerpt.cells) text += cell.text;
  if (excerpt.cut_back) text += kDots;
  indent.append(static_cast<std::size_t>(WidthOf(excerpt, 0, excerpt.caret)), ' ');
  return fmt::format("{}\n{}{}\n", text, indent, Painted("^", kGreen, color));
}

std::string Place(SourceMark mark, const Sources& sources) {
  if (mark.file == 0 || mark.file > sources.size()) return "mjforge";
  std::string place = SafeText(sources.Name(mark.file));
  if (mark.line > 0) place += fmt::format(":{}", mark.line);
  if (mark.line > 0 && mark.column > 0) place += fmt::format(":{}", mark.column);
  return place;
}

std::string Variant(const Finding& finding) {
  if (finding.seed && finding.index) {
    return fmt::format(" (seed {}, index {})", *finding.seed, *finding.index);
  }
  if (finding.seed) return fmt::format(" (seed {})", *finding.seed);
  return finding.index ? fmt::format(" (index {})", *finding.index) : std::string();
}

}  // namespace

std::string RenderText(const Finding& finding, const Sources& sources, bool color) {
  const bool is_error = finding.severity == Severity::kError;
  std::string out =
      fmt::format("{} {} {}{} [{}]\n", Painted(Place(finding.mark, sources) + ":", kBold, color),
                  Painted(is_error ? "error:" : "warning:", is_error ? kRed : kYellow, color),
                  SafeText(finding.message), Variant(finding), CodeName(finding.code));
  out += Quote(finding.mark, sources, color);
  if (!finding.hint.empty()) out += fmt::format("  hint: {}\n", SafeText(finding.hint));
  for (const Note& note : finding.notes) {
    out += fmt::format("{} {} {}\n", Painted(Place(note.mark, sources) + ":", kBold, color),
                       Painted("note:", kBold, color), SafeText(note.message));
    out += Quote(note.mark, sources, color);
  }
  return out;
}

}  // namespace mjforge::diag
