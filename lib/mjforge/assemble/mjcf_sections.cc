// Reads elements of MJCF sections (sensor, actuator, ...) with their references to other elements,
// and completes attributes for MuJoCo 2.2.

#include "mjforge/assemble/mjcf_sections.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Names of a range attribute and of the attribute that enables it. A range is in force unless the
// spec disables it. The enabling attribute is always written, because its default differs between
// releases of MuJoCo.
struct LimitAttributes {
  std::string_view range;
  std::string_view limited;
};
constexpr LimitAttributes kLimits[] = {{"range", "limited"},
                                       {"ctrlrange", "ctrllimited"},
                                       {"forcerange", "forcelimited"},
                                       {"actrange", "actlimited"}};

void SetLimited(const spec::ElementInfo& info, std::vector<model::Attribute>& attributes) {
  const auto has = [&](std::string_view name) {
    return model::FindAttribute(attributes, name) != nullptr;
  };
  for (const LimitAttributes& limit : kLimits) {
    const spec::FieldInfo* limited = info.Find(limit.limited);
    if (limited == nullptr || !has(limit.range) || has(limit.limited)) continue;
    attributes.push_back({.name = limited->key, .text = "true"});
  }
}

// Changes the length of a list of numbers to the length that MuJoCo 2.2 requires: appends the
// defaults of missing numbers, and reduces equal numbers to one if MuJoCo reads only one.
void SetLength(const spec::FieldInfo& info, model::AttributeNumbers& numbers) {
  if (info.default_text.empty()) return;
  std::vector<double> usual;
  for (std::string_view rest = info.default_text; !rest.empty();) {
    usual.push_back(*expr::ParseNumber(diag::CutAt(',', rest)));
  }
  for (std::size_t i = numbers.size(); i < usual.size(); ++i) numbers.Change().push_back(usual[i]);
  if (usual.size() != 1 || numbers.size() == 1) return;
  if (std::ranges::count(numbers, numbers[0]) == std::ssize(numbers)) numbers.Change().resize(1);
}

}  // namespace

void Sections::Add(Scope& scope, bool outermost) {
  const spec::ObjectSpec& spec = scope.values.spec();
  const sample::StreamId mjcf = sample::Child(scope.values.root(), "mjcf");
  for (const spec::Section& section : spec.sections) {
    const sample::StreamId path = sample::Child(mjcf, section.info->name);
    if (section.info->is_element && !outermost) {
      findings_.Warn(
          Code::kAttachNotCarried, section.entries.front().mark,
          fmt::format("'{}' of spec '{}' is left out: it would apply to the whole object",
                      section.info->name, spec.name),
          "write it in the outermost spec");
      continue;
    }
    for (const spec::Entry& entry : section.entries) {
      repetition_.Expand(entry, scope.values, path, ElementsOf(*section.info).size(),
                         [&] { AddElement(scope, *section.info, entry, path); });
    }
  }
}

void Sections::AddElement(Scope& scope, const spec::SectionInfo& section, const spec::Entry& entry,
                          sample::StreamId path) {
  std::string name;
  const auto* text = std::get_if<spec::Text>(&entry.name.form);
  if (text != nullptr && !text->pieces.empty()) {
    const std::optional<std::string> read = ReadName(scope, entry, path, findings_);
    if (!read) return;
    name = *read;
  }
  FieldReader reader(scope.values, findings_, entry.element->name, name,
                     sample::Child(path, std::string_view(name)));
  std::vector<model::Element>& elements = ElementsOf(section);
  model::Element element;
  if (!name.empty()) element.name = scope.prefix + name;
  if (ReadElement(scope, reader, entry, element, {&section, elements.size()})) {
    elements.push_back(std::move(element));
  }
}

bool Sections::ReadElement(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                           model::Element& element, References::ElementPlace place) {
  element.tag = entry.element->name;
  element.mark = entry.mark;
  bool good = true;
  for (const spec::Field& field : entry.fields) {
    model::Attribute& attribute = element.attributes.emplace_back();
    if (!reader.ReadAttribute(field, attribute))
      good = false;
    else
      SetLength(*field.info, attribute.numbers);
  }
  if (!good) return false;
  const spec::ObjectSpec& spec = scope.values.spec();
  for (std::size_t i = 0; i < element.attributes.size(); ++i) {
    model::Attribute& attribute = element.attributes[i];
    if (attribute.refers.empty()) continue;
    const std::string_view kind = KindOf(attribute, element);
    std::string shown = attribute.text;
    const bool is_root = kind.ends_with("body") && shown == spec.name;
    attribute.text =
        is_root ? object_.bodies[static_cast<std::size_t>(scope.body)].name : scope.prefix + shown;
    references_.Add(place, kind, attribute.text, std::move(shown),
                    fmt::format("{} of {}", attribute.name, reader.Owner()),
                    entry.fields[i].value.mark);
  }
  SetLimited(*entry.element, element.attributes);
  for (const spec::Entry& child : entry.children) {
    const std::string_view tag = child.element->name;
    const auto same = std::ranges::count(element.children, tag, &model::Element::tag);
    FieldReader child_reader = reader.ForChild(tag, static_cast<std::size_t>(same));
    good &= ReadElement(scope, child_reader, child, element.children.emplace_back(), place);
  }
  return good;
}

}  // namespace mjforge::assemble
