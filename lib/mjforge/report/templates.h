#pragma once

// The page's files, embedded, and how their holes are filled. Every value is escaped as its place
// needs, except the few that a file marks with `:none`.

#include <cstdint>
#include <cstring>  // that ctemplate's headers forget
#include <string>
#include <string_view>

#include <ctemplate/template_dictionary.h>

namespace mjforge::report {

using Dictionary = ctemplate::TemplateDictionary;

enum class TemplateName { kPage, kCard, kHistogram, kBars, kScatter };

/// A template with its holes filled.
std::string Expand(TemplateName name, const Dictionary& dictionary);

/// The chart that a hole `{{>MARKER}}` of the parent's template shows.
Dictionary& Include(Dictionary& parent, const char* marker, TemplateName name);

/// Shows a section, once per call.
inline Dictionary& Section(Dictionary& parent, const char* name) {
  return *parent.AddSectionDictionary(name);
}
void Set(Dictionary& dictionary, const char* name, std::string_view value);
void Set(Dictionary& dictionary, const char* name, double place);  // in a chart: one decimal
/// A section that holds one text, {{TEXT}}; not shown if it is empty.
void ShowText(Dictionary& parent, const char* section, std::string_view text);

/// Text of unknown origin, fit to be shown on one line: no control characters, valid UTF-8,
/// no longer than `limit` bytes and three dots.
std::string Clean(std::string_view text, std::size_t limit = 300);

/// "aGk=", as in RFC 4648.
std::string Base64(std::string_view bytes);

/// "1,234,567".
std::string Counted(std::uint64_t number);
/// "1 variant", "2 variants".
std::string Counted(std::uint64_t number, std::string_view noun);
/// "12.5 %"; 0 and 100 only for none and all.
std::string ShareText(std::uint64_t part, std::uint64_t whole);

}  // namespace mjforge::report
