#include "mjforge/mjcf/sections.h"

#include <string_view>

namespace mjforge::mjcf {
namespace {

// `custom` names no body; it stands with the settings, before what may need it.
bool IsSetting(const model::Section& section) {
  return section.info->is_element || section.info->name == "custom";
}

void WriteSection(const model::Section& section, ElementWriter& writer) {
  if (section.info->is_element) {
    for (const model::Element& element : section.elements) WriteElement(element, writer);
    return;
  }
  writer.Open(section.info->name);
  writer.Content();
  for (const model::Element& element : section.elements) WriteElement(element, writer);
  writer.End(section.info->name);
}

}  // namespace

void WriteElement(const model::Element& element, ElementWriter& writer) {
  writer.Open(element.tag, element.mark);
  if (!element.name.empty()) writer.Text("name", element.name);
  for (const model::Attribute& attribute : element.attributes) writer.Attribute(attribute);
  if (element.children.empty()) {
    writer.Close();
    return;
  }
  writer.Content();
  for (const model::Element& child : element.children) WriteElement(child, writer);
  writer.End(element.tag);
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
