// Access to attributes of XML elements, their descriptions, and findings about them.
#include "mjforge/xml/element.h"

#include <algorithm>

#include <fmt/format.h>

namespace mjforge::xml {
namespace {

diag::Finding& WithNote(diag::Finding& finding, diag::SourceMark place) {
  if (place) finding.notes.push_back({place, "here"});
  return finding;
}

}  // namespace

const std::string* XmlElement::Find(std::string_view attribute) const {
  for (const auto& [name, value] : attributes) {
    if (name == attribute) return &value;
  }
  return nullptr;
}

void XmlElement::Set(std::string_view attribute, std::string value) {
  for (auto& [name, old] : attributes) {
    if (name != attribute) continue;
    old = std::move(value);
    return;
  }
  attributes.emplace_back(attribute, std::move(value));
}

void XmlElement::Remove(std::string_view attribute) {
  std::erase_if(attributes, [&](const auto& pair) { return pair.first == attribute; });
}

std::string XmlElement::Name() const {
  const std::string* name = Find("name");
  return name == nullptr ? "" : *name;
}

std::string XmlElement::AssetName() const {
  std::string name = Name();
  const std::string* file = Find("file");
  if (!name.empty() || file == nullptr) return name;
  name = file->substr(file->find_last_of("/\\") + 1);
  return name.erase(std::min(name.find_last_of('.'), name.size()));
}

std::string XmlElement::Description() const {
  const std::string name = Name();
  return name.empty() ? fmt::format("the {} on line {}", tag, mark.line)
                      : fmt::format("{} '{}'", tag, name);
}

diag::Finding& AddError(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                        std::string message, std::string hint) {
  return WithNote(findings.Add(code, {}, std::move(message), std::move(hint)), place);
}

diag::Finding& AddWarning(diag::Findings& findings, diag::Code code, diag::SourceMark place,
                          std::string message, std::string hint) {
  return WithNote(findings.Warn(code, {}, std::move(message), std::move(hint)), place);
}

}  // namespace mjforge::xml
