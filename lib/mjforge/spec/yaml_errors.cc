// Replacement of yaml-cpp's messages about syntax errors by clear messages with hints.

#include "mjforge/spec/yaml_errors.h"

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/spec/spec.h"
#include "mjforge/spec/value_reader.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {
namespace {

// Returns the value that begins at `begin` in a line with braces or brackets. The value ends before
// the first blank, comma or closing bracket outside `${...}`. Returns an empty text if a `${` in
// the value is never closed.
std::string_view FlowValue(std::string_view line, std::size_t begin) {
  bool inside = false;
  std::size_t end = begin;
  for (; end < line.size(); ++end) {
    if (line.substr(end).starts_with("${")) inside = true;
    if (!inside && std::string_view(" ,]}").find(line[end]) != std::string_view::npos) break;
    if (line[end] == '}') inside = false;
  }
  return inside ? std::string_view() : line.substr(begin, end - begin);
}

// Returns the value at the end of the line. The value begins after the first `: ` before the column
// or, if there is none, after the first `- `.
std::string_view LineValue(std::string_view line, std::size_t column) {
  const std::string_view before = line.substr(0, column);
  std::size_t begin = before.find(": ");
  if (begin == before.npos) begin = before.find("- ");
  std::string_view value = begin == before.npos ? line : line.substr(begin + 2);
  if (const std::size_t end = value.rfind('}'); end != value.npos)
    value = value.substr(0, value.find(" #", end));  // without the comment
  return Trim(value);
}

// Returns the value in single quotes or, if the value contains single quotes, in double quotes. If
// the value also contains double quotes or a backslash, uses single quotes, and doubles the single
// quotes in the value.
std::string Quoted(std::string_view value) {
  const bool prefers_double =
      value.find('\'') != value.npos && value.find_first_of("\"\\") == value.npos;
  return prefers_double ? fmt::format("\"{}\"", value) : SingleQuoted(value);
}

std::string QuoteHint(std::string_view value) {
  return value.empty() ? "put quotes around the whole value"
                       : fmt::format("write {}", Quoted(value));
}

// Returns the offset of the last `${` before the column; npos if there is none, or if the line has
// a `}` between this `${` and the column.
std::size_t OpenInterpolation(std::string_view line, std::size_t column) {
  const std::size_t open = line.substr(0, column).rfind("${");
  if (open == line.npos) return open;
  return line.substr(open, column - 1 - open).find('}') == line.npos ? open : line.npos;
}

// Returns true if a bracket directly follows a name: `widths[i]`.
bool HasItem(std::string_view line) {
  for (auto at = line.find('['); at != line.npos; at = line.find('[', at + 1)) {
    if (at > 0 && expr::IsNameCharacter(line[at - 1])) return true;
  }
  return false;
}

// Replaces obscure messages of yaml-cpp by clear ones.
std::string Reworded(const std::string& message) {
  struct Wording {
    std::string_view theirs;
    std::string_view ours;
  };
  static constexpr Wording kWordings[] = {
      {"end of map not found",
       "this line matches none of the indentations above (are they consistent?)"},
      {"end of sequence not found",
       "this line matches none of the indentations above (are they consistent?)"},
      {"end of sequence flow not found", "'[' without ']', or a comma is missing"},
      {"end of map flow not found", "'{' without '}', or a comma is missing"},
      {"illegal map value", "a colon where no key is allowed (quote the text if it contains ': ')"},
      {"illegal flow end", "a closing bracket that nothing opened"},
      {"illegal block entry", "'-' where no list is allowed (are there tabs? indent with spaces)"},
      {"illegal map key", "a key where none is allowed (is the indentation consistent?)"},
  };
  for (const Wording& wording : kWordings) {
    if (message.starts_with(wording.theirs)) return std::string(wording.ours);
  }
  return message;
}

// Returns a hint for brackets or braces that seem to have no end; empty if the cause is unknown.
std::string FlowHint(std::string_view line) {
  if (HasItem(line))
    return "in braces or brackets an item of a list is quoted: [\"widths[i]\", 0, 0]";
  if (line.find(" ? ") != line.npos)
    return "in braces or brackets a choice is quoted: [\"wide ? 2cm : 1cm\", 0, 0]";
  return {};
}

}  // namespace

SyntaxError ExplainSyntax(const std::string& error, std::string_view line, std::size_t column) {
  const std::size_t open = OpenInterpolation(line, column);
  if (open != line.npos && column == open + 2) {
    // YAML interprets the brace of `${` as the beginning of a mapping.
    const std::string_view value = FlowValue(line, line.find_last_of(" ,[{", open) + 1);
    const bool has_colon = value.empty() || value.find(": ") != value.npos;
    return {"in braces or brackets a value with '${...}' needs quotes",
            QuoteHint(value) + (has_colon ? "" : ", or put it on a line of its own")};
  }
  const bool is_colon =
      error.starts_with("illegal map value") || error.starts_with("illegal flow end");
  if (open != line.npos && is_colon)
    return {"a value with ': ' in '${...}' needs quotes", QuoteHint(LineValue(line, open))};
  const bool in_flow = error.find("flow not found") != std::string::npos;
  return {Reworded(error), in_flow ? FlowHint(line) : ""};
}

}  // namespace mjforge::spec
