// The reference chapter of the manual, made from the tables of fields, sections and distributions.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/spec/field_kinds.h"
#include "mjforge/spec/spec.h"

namespace mjforge::spec {
namespace {

std::string TakenBy(const FieldInfo& field) {
  if (field.kind == FieldKind::kStructure) return std::string(field.structure.takes);
  const std::string_view takes = InfoOf(field.kind).takes;
  if (!field.words.empty()) {
    return fmt::format("{}{}{}", fmt::join(expr::WordsOf(field.words), ", "),
                       takes.empty() ? "" : " or ", takes);
  }
  if (field.kind != FieldKind::kNumbers) return std::string(takes);
  return field.min_count == field.max_count
             ? fmt::format("{} numbers", field.max_count)
             : fmt::format("{} to {} numbers", field.min_count, field.max_count);
}

std::string BoundsText(const FieldInfo& field) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::string text;
  if (field.lower > -kInfinity) {
    text = fmt::format("{} {}", field.above ? ">" : ">=", expr::NumberText(field.lower));
  }
  if (field.upper < kInfinity) {
    text += fmt::format("{}<= {}", text.empty() ? "" : ", ", expr::NumberText(field.upper));
  }
  return text;
}

// Escapes "|", which would end a cell of a Markdown table.
std::string Cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string ElementTable(const ElementInfo& element) {
  std::string out = fmt::format("## {}{}\n\n{}\n\n",
                                std::string(1, static_cast<char>(element.name[0] - 'a' + 'A')),
                                element.name.substr(1), element.doc);
  out +=
      "| key | takes | unit | bounds | default | meaning |\n| --- | --- | --- | --- | --- | --- "
      "|\n";
  for (const FieldInfo& field : element.fields) {
    out += fmt::format("| `{}`{} | {} | {} | {} | {} | {} |\n", field.key,
                       field.required ? " (required)" : "", TakenBy(field), field.unit,
                       BoundsText(field), Cell(field.default_text), Cell(field.doc));
  }
  return out + "\n";
}

// Returns the names of the attributes, with the kinds of elements that they refer to. MuJoCo's
// manual explains the attributes.
std::string AttributeList(const ElementInfo& element) {
  std::string out;
  for (const FieldInfo& field : element.fields) {
    out += fmt::format("{}`{}`", out.empty() ? "" : ", ", field.key);
    if (field.refers.starts_with('@')) {
      out += fmt::format("  (given by `{}`)", field.refers.substr(1));
    } else if (!field.refers.empty()) {
      out += fmt::format(" ({})", field.refers);
    }
  }
  return out;
}

std::string SectionTables() {
  std::string out =
      "## Sections of `mjcf:`\n\n"
      "Attributes as in MuJoCo's XML reference. Brackets show the kind of element that an "
      "attribute refers to.\n\n"
      "| section | element | attributes |\n| --- | --- | --- |\n";
  for (const SectionInfo& section : Sections()) {
    for (const ElementInfo& element : section.elements) {
      out += fmt::format("| `{}` | {} | {} |\n", section.name,
                         section.is_element ? "" : fmt::format("`{}`", element.name),
                         AttributeList(element));
      for (const ElementInfo& child : element.children) {
        out += fmt::format("| | in it `{}` | {} |\n", child.name, AttributeList(child));
      }
    }
  }
  return out + "\n";
}

}  // namespace

std::string FieldReference() {
  std::string out =
      "# Reference\n\n"
      "Generated from the program's field table; a test fails when this page is out of date.\n\n";
  for (const ElementInfo* element : AllElements()) out += ElementTable(*element);
  out += SectionTables();

  out += "## Distributions\n\n| form | meaning |\n| --- | --- |\n";
  out += "| `lo .. hi` | The same as `{uniform: [lo, hi]}`. |\n";
  for (const DistributionInfo& info : Distributions()) {
    out += fmt::format("| `{}` | {} |\n", info.usage, Cell(info.doc));
  }
  out +=
      "| `quat: random` | A rotation, uniform on SO(3). |\n"
      "| `{about: [x, y, z]}` | A rotation about an axis by a uniform angle. |\n"
      "| `{on_sphere: r}` | A point, uniform on the sphere of radius r. |\n"
      "| `{hsv: [h, s, v]}` | A colour from hue, saturation and value, each 0 to 1. |\n\n";

  out += "## Functions\n\n| function | meaning |\n| --- | --- |\n";
  for (const expr::BuiltinInfo& function : expr::Builtins()) {
    out += fmt::format("| `{}` | {} |\n", function.usage, Cell(function.doc));
  }
  out +=
      "\n## Units\n\nA unit directly follows its number: `15mm`, `90deg`.\n\n"
      "| unit | meaning |\n| --- | --- |\n";
  for (const expr::Unit& unit : expr::Units()) {
    out += fmt::format("| `{}` | {} |\n", unit.name, Cell(unit.doc));
  }
  return out;
}

}  // namespace mjforge::spec
