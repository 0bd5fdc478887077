// JSON Schema of specs (draft-07), with which an editor completes and checks specs.
//
// The schema checks the structure of specs. Names, expressions and references are checked only by
// the readers of specs. schema.json is the schema with markers "@KIND NAME", which are replaced by
// text made from the tables of fields, sections and distributions. The inserted text may contain
// markers, too.

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rapidjson/prettywriter.h>
#include <rapidjson/reader.h>
#include <rapidjson/stringbuffer.h>

#include "mjforge/spec/field_kinds.h"
#include "mjforge/spec/spec.h"

namespace mjforge::spec {

extern const std::string_view kSchemaJson;  // content of schema.json

namespace {

using JsonMembers = std::vector<std::string>;

// Schema of an expression: a text that does not look like a number, because a number in quotes is a
// text in specs, not an expression.
constexpr std::string_view kExpression =
    R"x("type": "string", "pattern": "^(?![-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?$)")x";
constexpr std::string_view kNamePattern = R"("^[A-Za-z][A-Za-z0-9_]*$")";

std::string Quoted(std::string_view text) {
  rapidjson::StringBuffer buffer;
  rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
  writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  return buffer.GetString();
}

std::string Joined(const JsonMembers& members) {
  return fmt::format("{}", fmt::join(members, ", "));
}

// Returns a JSON member whose value is an object with the given members.
std::string Member(std::string_view key, std::string_view members) {
  return fmt::format(R"("{}": {{{}}})", key, members);
}

std::string Is(std::string_view definition) { return fmt::format(R"("@is {}")", definition); }

std::string ListOf(std::string_view members) {
  return fmt::format(R"("type": "array", "items": {{{}}})", members);
}

std::string Mapping(const JsonMembers& properties) {
  return fmt::format(R"("type": "object", "properties": {{{}}}, "additionalProperties": false)",
                     Joined(properties));
}

const ElementInfo* FindElement(std::string_view name) {
  return *std::ranges::find(AllElements(), name, &ElementInfo::name);
}

// --- Schemas of fields ------------------------------------------------------

bool IsBounded(const FieldInfo& field) {
  return std::isfinite(field.lower) || std::isfinite(field.upper);
}

std::string Literal(const FieldInfo& field, std::string_view type) {
  std::string text = fmt::format(R"("type": "{}")", type);
  if (std::isfinite(field.lower)) {
    text += fmt::format(R"(, "{}": {})", field.above ? "exclusiveMinimum" : "minimum",
                        expr::NumberText(field.lower));
  }
  if (std::isfinite(field.upper)) {
    text += fmt::format(R"(, "maximum": {})", expr::NumberText(field.upper));
  }
  return text;
}

std::string Number(const FieldInfo& field, std::string_view type) {
  return fmt::format(R"("anyOf": [{{{}}}, {{"@expression"}}, {{"@is number_draw"}}])",
                     Literal(field, type));
}

std::string NumbersName(const FieldInfo& field) {
  return fmt::format("numbers_{}_{}", field.min_count, field.max_count);
}

std::string Numbers(const FieldInfo& field) {
  const std::string alone =
      field.min_count == 1 ? fmt::format("{{{}}}, ", Literal(field, "number")) : "";
  return fmt::format(
      R"("anyOf": [{{"type": "array", "items": {{{}}}, "minItems": {}, "maxItems": {}}}, )"
      R"({}{{"@expression"}}, {{"@is vector_draw"}}])",
      Number(field, "number"), field.min_count, field.max_count, alone);
}

std::string Words(const FieldInfo& field) {
  return fmt::format(R"({{"enum": [{}]}})", diag::Joined(expr::WordsOf(field.words), ", ", Quoted));
}

std::string Word(const FieldInfo& field) {
  return fmt::format(
      R"("anyOf": [{}, {{"type": "string", "pattern": "\\$\\{{"}}, {{"@is text_draw"}}])",
      Words(field));
}

std::string PlainText(const FieldInfo& field) {
  if (field.id == Key::kName)
    return fmt::format(R"("type": "string", "pattern": {})", kNamePattern);
  // Allows numbers, because `unit: 1` is text in a spec but a number in YAML.
  return R"("anyOf": [{"type": "string"}, {"type": "number"}])";
}

// Returns the schema for a key of `defaults:`: all fields of the element, none of them required.
std::string DefaultFields(const FieldInfo& defaults) {
  const ElementInfo& element = *FindElement(defaults.key);
  return Mapping(diag::Mapped<std::string>(element.fields, [&](const FieldInfo& field) {
    return Member(field.key, Is(fmt::format("{}/properties/{}", element.name, field.key)));
  }));
}

std::string Silence() {
  JsonMembers properties;
  for (const diag::CodeInfo& info : diag::AllCodes()) {
    if (!CanBeSilenced(info.code)) continue;
    properties.push_back(Member(info.name, R"("type": "string")"));
  }
  return Mapping(properties);
}

std::string SectionProperties() {
  return Mapping(diag::Mapped<std::string>(Sections(), [](const SectionInfo& section) {
    return Member(section.name, Is(section.name));
  }));
}

// Returns the schema of the values that a field accepts.
std::string Taken(const FieldInfo& field) {
  switch (field.kind) {
    case FieldKind::kNumber:
      return IsBounded(field) ? Number(field, "number") : Is("number");
    case FieldKind::kInteger:
      return Number(field, "integer");
    case FieldKind::kWord:
      return Word(field);
    case FieldKind::kNumbers:
      return IsBounded(field) ? Numbers(field) : Is(NumbersName(field));
    case FieldKind::kPoints:
      return Is(field.min_count == 2 ? "points" : "points_in_space");
    case FieldKind::kPlainText:
      return PlainText(field);
    case FieldKind::kJoints:
      return fmt::format(R"("anyOf": [{}, {{"@list joint"}}])", Words(field));
    case FieldKind::kFields:
      return DefaultFields(field);
    case FieldKind::kSections:
      return SectionProperties();
    case FieldKind::kSilence:
      return Silence();
    case FieldKind::kStructure:
      return std::string(field.structure.schema);
    default:
      return std::string(InfoOf(field.kind).schema);
  }
}

std::string Property(const FieldInfo& field) {
  std::string text(field.doc);
  if (!field.unit.empty()) text += fmt::format(" Unit: {}.", field.unit);
  if (!field.default_text.empty()) text += fmt::format(" Default: {}.", field.default_text);
  return Member(field.key, fmt::format(R"("description": {}, {})", Quoted(text), Taken(field)));
}

// --- Schemas of draws -------------------------------------------------------

std::string DrawArguments(const DistributionInfo& info) {
  if (info.arguments < 0) return R"("type": "array", "minItems": 1)";
  const std::string list =
      fmt::format(R"("@list number", "minItems": {0}, "maxItems": {0})", info.arguments);
  return info.arguments > 1 ? list : fmt::format(R"("anyOf": [{{"@is number"}}, {{{}}}])", list);
}

std::string DrawForm(const DistributionInfo& info, const JsonMembers& more_properties) {
  JsonMembers properties = {Member(info.key, DrawArguments(info))};
  if (info.option == "weights") {
    // Also allows a text, the name of the record's column that contains the weights.
    properties.push_back(
        Member(info.option, R"("anyOf": [{"@list number", "minItems": 1}, {"type": "string"}])"));
  } else if (!info.option.empty()) {
    properties.push_back(Member(info.option, R"("@list number", "minItems": 2, "maxItems": 2)"));
  }
  if (!info.flag.empty()) properties.push_back(Member(info.flag, R"("type": "boolean")"));
  properties.insert(properties.end(), more_properties.begin(), more_properties.end());
  return fmt::format(
      R"("type": "object", "description": {}, "properties": {{{}}}, "required": ["{}"], )"
      R"("additionalProperties": false)",
      Quoted(fmt::format("{}: {}", info.usage, info.doc)), Joined(properties), info.key);
}

bool Gives(const DistributionInfo& info, std::string_view kind) {
  if (kind == "any") return true;
  if (info.id == Distribution::kBernoulli) return kind == "boolean";
  return info.arguments < 0 || kind == "number";
}

// --- Schemas of MJCF sections -----------------------------------------------

// Returns the schema of a mapping with one key that names one of the elements; `properties` are
// additional members.
std::string OneOf(std::span<const ElementInfo> elements, JsonMembers properties);

std::string Attributes(const ElementInfo& element, bool children_by_name) {
  JsonMembers properties;
  for (const FieldInfo& field : element.fields) {
    properties.push_back(
        Member(field.key, Is(field.kind == FieldKind::kNumbers   ? "attribute_numbers"
                             : field.kind == FieldKind::kBoolean ? "boolean"
                                                                 : "text")));
  }
  if (children_by_name) {
    for (const ElementInfo& child : element.children) {
      properties.push_back(Member(child.name, Attributes(child, false)));
    }
  } else if (!element.children.empty()) {
    properties.push_back(Member("children", ListOf(OneOf(element.children, {}))));
  }
  return Mapping(properties);
}

std::string OneOf(std::span<const ElementInfo> elements, JsonMembers properties) {
  for (const ElementInfo& element : elements) {
    properties.push_back(Member(element.name, Attributes(element, false)));
  }
  return Mapping(properties);
}

// --- Texts for the markers in schema.json -----------------------------------

std::string Fields(std::string_view element) {
  return fmt::format(R"("properties": {{{}}}, "additionalProperties": false)",
                     diag::Joined(FindElement(element)->fields, ", ", Property));
}

std::string Doc(std::string_view element) {
  return fmt::format(R"("description": {})", Quoted(FindElement(element)->doc));
}

// Returns the JSON properties that describe a parameter: doc, unit and section.
std::string About(std::string_view /*none*/) {
  const ElementInfo& parameter = kParameterElement;
  return Joined({Property(*parameter.Find(Key::kDoc)), Property(*parameter.Find(Key::kUnit)),
                 Property(*parameter.Find(Key::kSection))});
}

std::string Draws(std::string_view /*none*/) {
  return diag::Joined(Distributions(), ", ", [](const DistributionInfo& info) {
    return Member(info.key, DrawForm(info, {}));
  });
}

std::string DrawsOf(std::string_view kind) {
  JsonMembers draws;
  for (const DistributionInfo& info : Distributions()) {
    if (Gives(info, kind)) draws.push_back(fmt::format("{{{}}}", Is(info.key)));
  }
  return Joined(draws);
}

std::string DrawsWithDoc(std::string_view none) {
  return diag::Joined(Distributions(), ", ", [none](const DistributionInfo& info) {
    return fmt::format("{{{}}}", DrawForm(info, {About(none)}));
  });
}

// Returns definitions for lists of numbers without bounds: one for each pair of a minimum and a
// maximum count.
std::string NumberLists(std::string_view /*none*/) {
  std::set<std::string> done;
  JsonMembers lists;
  for (const ElementInfo* element : AllElements()) {
    for (const FieldInfo& field : element->fields) {
      if (field.kind != FieldKind::kNumbers || IsBounded(field)) continue;
      if (!done.insert(NumbersName(field)).second) continue;
      lists.push_back(Member(NumbersName(field), Numbers(field)));
    }
  }
  return Joined(lists);
}

std::string SectionDefinitions(std::string_view /*none*/) {
  const JsonMembers repeats = {
      Member("if", Is("condition")),
      Member("for", R"("type": "object", "additionalProperties": {"@is number"})"),
      Member("let", R"("@map value")")};
  return diag::Joined(Sections(), ", ", [&](const SectionInfo& section) {
    return Member(section.name, section.is_element ? Attributes(section.elements.front(), true)
                                                   : ListOf(OneOf(section.elements, repeats)));
  });
}

struct Marker {
  std::string_view kind;
  std::string (*text)(std::string_view name);
};
constexpr Marker kMarkers[] = {
    {"doc", Doc},
    {"fields", Fields},
    {"about", About},
    {"draws", Draws},
    {"draws_of", DrawsOf},
    {"draws_with_doc", DrawsWithDoc},
    {"number_lists", NumberLists},
    {"sections", SectionDefinitions},
    {"element",
     [](std::string_view name) {
       return fmt::format(R"("type": "object", "@doc {0}", "@fields {0}")", name);
     }},
    {"expression", [](std::string_view) { return std::string(kExpression); }},
    {"is",
     [](std::string_view name) { return fmt::format(R"("$ref": "#/definitions/{}")", name); }},
    {"list", [](std::string_view name) { return ListOf(Is(name)); }},
    {"map",
     [](std::string_view name) {
       return fmt::format(R"("type": "object", "patternProperties": {{{}: {{"@is {}"}}}}, )"
                          R"("additionalProperties": false)",
                          kNamePattern, name);
     }},
    {"pair",
     [](std::string_view) { return std::string(R"("@list text", "minItems": 2, "maxItems": 2)"); }},
};

std::string Expand(std::string_view text) {
  std::string out;
  for (std::size_t at = text.find("\"@"); at != std::string_view::npos; at = text.find("\"@")) {
    out += text.substr(0, at);
    text.remove_prefix(at + 2);
    const std::string_view marker = text.substr(0, text.find('"'));
    text.remove_prefix(marker.size() + 1);
    if (text.starts_with(": 0")) text.remove_prefix(3);
    const std::vector<std::string_view> words = expr::WordsOf(marker);
    const auto* found = std::ranges::find(kMarkers, words[0], &Marker::kind);
    out += Expand(found->text(words.back()));
  }
  return out.append(text);
}

}  // namespace

std::string JsonSchema() {
  const std::string compact = Expand(kSchemaJson);
  rapidjson::StringStream stream(compact.c_str());
  rapidjson::StringBuffer buffer;
  rapidjson::PrettyWriter<rapidjson::StringBuffer> writer(buffer);
  writer.SetIndent(' ', 2);
  rapidjson::Reader().Parse(stream, writer);
  return std::string(buffer.GetString()) + "\n";
}

}  // namespace mjforge::spec
