// An object adapted to a target, with its findings and its MJCF.
#pragma once

#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "hand_made.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/spec/fields.h"

namespace mjforge::mjcf::adapted {

using hand_made::Line;
using hand_made::Numbers;
using hand_made::Word;
using model::GeomType;
using model::Role;
using spec::Applies;

constexpr const char* kHosts[] = {"robosuite", "robocasa"};

/// Returns a box with a lid on a hinge, with names without prefix.
inline model::Object Chest() {
  model::Object object;
  object.name = "chest";
  model::Body& root = object.bodies.emplace_back();
  root.name = "object";
  root.mark = Line(1);
  root.joints.emplace_back().name = "joint0";
  root.joints.back().mark = Line(2);
  root.parts.push_back(hand_made::Solid("base", GeomType::kBox, {0.03, 0.04, 0.05},
                                        {{0.01, 0, 0}, {1, 0, 0, 0}}, 3));
  model::Body& lid = object.bodies.emplace_back();
  lid.name = "lid";
  lid.parent = 0;
  lid.X_PB.p = {0, 0, 0.06};
  lid.mark = Line(5);
  model::Joint& hinge = lid.joints.emplace_back();
  hinge.name = "hinge";
  hinge.type = "hinge";
  hinge.mark = Line(6);
  lid.parts.push_back(hand_made::Solid("plate", GeomType::kBox, {0.03, 0.04, 0.005}, {}, 7));
  hand_made::Weigh(object);
  object.bounds.top_offset = 0.065;
  object.bounds.bottom_offset = -0.05;
  object.bounds.horizontal_radius = 0.055;
  return object;
}

inline std::vector<std::string> Messages(const diag::Findings& findings) {
  std::vector<std::string> messages;
  for (const diag::Finding& finding : findings) {
    const bool is_error = finding.severity == diag::Severity::kError;
    messages.push_back(std::to_string(finding.mark.line) + (is_error ? " error: " : ": ") +
                       finding.message);
  }
  return messages;
}

/// Returns the findings of adapting the object.
inline std::vector<std::string> Adapted(model::Object& object, std::string_view target) {
  diag::Findings findings;
  Adapt(object, *FindTarget(target), findings);
  return Messages(findings);
}
using Said = std::vector<std::string>;

inline pugi::xml_document Written(const model::Object& object, std::string_view target) {
  MjcfDocument document;
  WriteMjcf(object, *FindTarget(target), {}, document);
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  return parsed;
}

inline model::Element Made(std::string_view section, std::string_view tag, std::string name,
                           std::uint32_t line, std::vector<model::Attribute> attributes = {}) {
  const spec::ElementInfo* info = spec::FindSection(section)->Find(tag);
  REQUIRE(info != nullptr);
  model::Element element;
  element.tag = info->name;
  element.name = std::move(name);
  element.mark = Line(line);
  for (model::Attribute& attribute : attributes) {
    if (const spec::FieldInfo* field = info->Find(attribute.name)) attribute.refers = field->refers;
    element.attributes.push_back(std::move(attribute));
  }
  return element;
}

inline model::Attribute Text(std::string_view name, std::string text) {
  return Word(name, Applies::kBoth, std::move(text));
}

inline void Add(model::Object& object, std::string_view section,
                std::vector<model::Element> elements) {
  object.sections.push_back({spec::FindSection(section), std::move(elements)});
}

}  // namespace mjforge::mjcf::adapted
