// Writing of a tree of XML elements as JSON, and recognition of numbers in attribute values.
#include "mjforge/xml/elements_json.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <pugixml.hpp>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::xml {
namespace {

constexpr int kMaxElementDepth = 100;
constexpr std::string_view kDigits = "0123456789";

// Removes the digits at the start of the text. Returns false if the text starts with another
// character.
bool SkipDigits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
  text.remove_prefix(end);
  return end > 0;
}

bool Skip(std::string_view& text, char c) {
  const bool found = text.starts_with(c);
  if (found) text.remove_prefix(1);
  return found;
}

// Returns true if the word is a number by the grammar of JSON.
bool IsJsonNumber(std::string_view word) {
  Skip(word, '-');
  const bool zero = word.starts_with('0');
  const std::size_t before = word.size();
  if (!SkipDigits(word) || (zero && before - word.size() > 1)) return false;
  if (Skip(word, '.') && !SkipDigits(word)) return false;
  if (word.starts_with('e') || word.starts_with('E')) {
    word.remove_prefix(1);
    if (!Skip(word, '-')) Skip(word, '+');
    if (!SkipDigits(word)) return false;
  }
  return word.empty();
}

void WriteValue(std::string_view value, diag::Json& json) {
  const std::vector<std::string_view> words = expr::WordsOf(value);
  if (words.empty() || !std::ranges::all_of(words, IsJsonNumber)) return json.Value(value);
  if (words.size() > 1) json.StartArray();
  for (const std::string_view word : words) json.Raw(word);
  if (words.size() > 1) json.EndArray();
}

// Appends an element to `json`. Returns false if elements are nested too deeply.
bool WriteElement(const pugi::xml_node& element, int depth, diag::Json& json) {
  if (depth > kMaxElementDepth) return false;
  json.StartArray();
  json.Value(element.name());
  json.StartObject();
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    json.Key(attribute.name());
    WriteValue(attribute.value(), json);
  }
  json.EndObject();
  json.StartArray();
  for (const pugi::xml_node& child : element.children()) {
    if (child.type() == pugi::node_element && !WriteElement(child, depth + 1, json)) return false;
  }
  json.EndArray();
  json.EndArray();
  return true;
}

}  // namespace

std::optional<std::string> ElementsJson(std::string_view mjcf) {
  pugi::xml_document document;
  if (!document.load_buffer(mjcf.data(), mjcf.size())) return std::nullopt;
  diag::Json json(nullptr);
  if (!WriteElement(document.document_element(), 1, json)) return std::nullopt;
  return json.Take();
}

}  // namespace mjforge::xml
