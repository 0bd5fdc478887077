// Writers of sections that are copied from the spec to MJCF: settings, contacts, tendons, sensors.

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// Returns true for sections that are written before the bodies. The section `custom` is among them,
// because `custom` refers to no body, and later elements may refer to `custom`.
bool IsSetting(const model::Section& section) {
  return section.info->is_element || section.info->name == "custom";
}

void WriteSection(const model::Section& section, ElementWriter& writer) {
  if (section.info->is_element) {
    for (const model::Element& element : section.elements) WriteElement(element, writer);
    return;
  }
  writer.OpenElement(section.info->name);
  writer.BeginContent();
  for (const model::Element& element : section.elements) WriteElement(element, writer);
  writer.EndElement(section.info->name);
}

}  // namespace

void WriteElement(const model::Element& element, ElementWriter& writer) {
  writer.OpenElement(element.tag, element.mark);
  if (!element.name.empty()) writer.WriteText("name", element.name);
  for (const model::Attribute& attribute : element.attributes) writer.WriteAttribute(attribute);
  if (element.children.empty()) {
    writer.CloseEmpty();
    return;
  }
  writer.BeginContent();
  for (const model::Element& child : element.children) WriteElement(child, writer);
  writer.EndElement(element.tag);
}

void WriteSettings(const model::Object& object, ElementWriter& writer) {
  for (const model::Section& section : object.sections) {
    if (IsSetting(section)) WriteSection(section, writer);
  }
}

void WriteSections(const model::Object& object, double lift, ElementWriter& writer) {
  for (const model::Section& section : object.sections) {
    if (!IsSetting(section)) WriteSection(section, writer);
  }
  WriteKeyframe(object, lift, writer);
}

}  // namespace mjforge::mjcf
