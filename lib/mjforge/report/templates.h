// Embedded HTML templates of reports and galleries, and functions that fill the templates.
//
// ctemplate escapes every value for its place in the HTML, except values that a template marks with
// `:none`.

#pragma once

#include <cstdint>
#include <cstring>  // needed, but not included, by ctemplate's headers
#include <string>
#include <string_view>

#include <ctemplate/template_dictionary.h>

#include "mjforge/report/thumbnail.h"

namespace mjforge::report {

using Dictionary = ctemplate::TemplateDictionary;

enum class TemplateName { kPage, kRow, kHistogram, kBars, kScatter, kPanels, kGallery, kSpec };

extern const std::string_view kPageCss;  // style of all pages

/// Fills a template with the values of a dictionary.
std::string Expand(TemplateName name, const Dictionary& dictionary);

/// Returns the dictionary of a chart that the parent's template includes at `{{>MARKER}}`.
Dictionary& Include(Dictionary& parent, const char* marker, TemplateName name);

/// Adds one copy of a template's section to the page, and returns the dictionary of the copy.
inline Dictionary& Section(Dictionary& parent, const char* name) {
  return *parent.AddSectionDictionary(name);
}
void Set(Dictionary& dictionary, const char* name, std::string_view value);
void Set(Dictionary& dictionary, const char* name, double place);  // writes one decimal
/// Shows a section with the text {{TEXT}}, unless the text is empty.
void ShowText(Dictionary& parent, const char* section, std::string_view text);

/// Makes a text of unknown origin safe to show on a line: valid UTF-8, no control characters, and
/// at most `limit` bytes and three dots.
std::string Clean(std::string_view text, std::size_t limit = 300);

/// Makes the lines of a spec safe to show; returns an empty text if the spec is too long for a
/// page.
std::string CleanSpec(std::string_view text);

/// Returns the Base64 text (RFC 4648) of bytes: "aGk=" for "hi".
std::string Base64(std::string_view bytes);

/// Fills in DATA, WIDTH and HEIGHT of a picture that is part of the page.
void SetPicture(Dictionary& picture, const Thumbnail& image);

/// Returns a number with thousands separators: "1,234,567".
std::string CountText(std::uint64_t number);
/// Returns a number with its noun: "1 variant", "2 variants".
std::string CountText(std::uint64_t number, std::string_view noun);
/// Returns a percentage: "12.5 %". "0 %" means no item, and "100 %" means all items.
std::string ShareText(std::uint64_t part, std::uint64_t whole);

}  // namespace mjforge::report
