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

/// Returns the text of a template after filling in the values of a dictionary; an empty text if
/// ctemplate fails.
std::string Expand(TemplateName name, const Dictionary& dictionary);

/// Includes the template `name` in the parent's template at `{{>MARKER}}`, and returns the
/// dictionary for its values.
Dictionary& Include(Dictionary& parent, const char* marker, TemplateName name);

/// Adds a copy of the section `name` of a template, and returns the dictionary of the copy.
inline Dictionary& Section(Dictionary& parent, const char* name) {
  return *parent.AddSectionDictionary(name);
}
void Set(Dictionary& dictionary, const char* name, std::string_view value);
void Set(Dictionary& dictionary, const char* name, double place);  // writes one decimal digit
/// Shows a section with the text {{TEXT}}, unless the text is empty.
void ShowText(Dictionary& parent, const char* section, std::string_view text);

/// Returns a text of unknown origin in a form that is safe to show on a line: valid UTF-8 without
/// control characters. Cuts the text to `limit` bytes and adds three dots if it is longer.
std::string Clean(std::string_view text, std::size_t limit = 300);

/// Returns the text of a spec with lines that are safe to show (Clean); an empty text if the spec
/// is too long for a page.
std::string CleanSpec(std::string_view text);

/// Returns the Base64 text (RFC 4648) of bytes: "aGk=" for "hi".
std::string Base64(std::string_view bytes);

/// Fills in DATA (a data: URL), WIDTH and HEIGHT of a picture.
void SetPicture(Dictionary& picture, const Thumbnail& image);

/// Returns a number with thousands separators: "1,234,567".
std::string CountText(std::uint64_t number);
/// Returns a number with its noun: "1 variant", "2 variants".
std::string CountText(std::uint64_t number, std::string_view noun);
/// Returns `part` divided by `whole`; 0 if both are 0.
double Share(std::uint64_t part, std::uint64_t whole);
/// Returns `part` as a percentage of `whole`: "12.5 %". Returns "0 %" only for no item, and "100 %"
/// only for all items.
std::string ShareText(std::uint64_t part, std::uint64_t whole);

}  // namespace mjforge::report
