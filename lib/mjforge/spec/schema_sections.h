#ifndef MJFORGE_SPEC_SCHEMA_SECTIONS_H_
#define MJFORGE_SPEC_SCHEMA_SECTIONS_H_

// The definitions of the JSON Schema that describe `contact:` and `mjcf:`.

#include <string_view>

#include "mjforge/spec/schema_draws.h"
#include "mjforge/spec/sections.h"

namespace mjforge::spec {

class SectionSchema : protected DrawSchema {
 protected:
  /// One definition for each section, and those they share.
  void SectionDefinitions() {
    Define("attribute_numbers", [this] {
      AnyOf({[this] { ListOf("number"); }, [this] { Text("type", "number"); },
             [this] { Expression(); }, [this] { Ref("vector_draw"); }});
    });
    for (const SectionInfo& section : Sections()) {
      Define(section.name, [&] {
        if (section.is_element) return Attributes(section.elements.front(), true);
        Text("type", "array");
        Key("items");
        Object([&] { OneOf(section.elements, true); });
      });
    }
  }

  /// `mjcf:` itself.
  void SectionProperties() {
    Text("type", "object");
    Key("properties");
    Object([this] {
      for (const SectionInfo& section : Sections())
        Define(section.name, [&] { Ref(section.name); });
    });
    NoOtherKeys();
  }

  /// `exclude:`: pairs and their long form.
  void Excludes() {
    Text("type", "array");
    Key("items");
    Object([this] { AnyOf({[this] { BodyPair(); }, [this] { Ref("exclude"); }}); });
  }
  void BodyPair() {
    ListOf("text");
    Count("minItems", 2);
    Count("maxItems", 2);
  }

 private:
  // A mapping whose one key is an element.
  void OneOf(std::span<const ElementInfo> elements, bool may_repeat) {
    Text("type", "object");
    Key("properties");
    Object([&] {
      if (may_repeat) {
        Define("if", [this] { Ref("condition"); });
        Define("for", [this] {
          Text("type", "object");
          Key("additionalProperties");
          Object([this] { Ref("number"); });
        });
      }
      for (const ElementInfo& element : elements) {
        Define(element.name, [&] { Attributes(element, false); });
      }
    });
    NoOtherKeys();
  }

  void Attributes(const ElementInfo& element, bool children_by_name) {
    Text("type", "object");
    Key("properties");
    Object([&] {
      for (const FieldInfo& field : element.fields) {
        Define(field.key, [&] {
          Ref(field.slot == Slot::kNumbers   ? "attribute_numbers"
              : field.slot == Slot::kBoolean ? "boolean"
                                             : "text");
        });
      }
      if (children_by_name) {
        for (const ElementInfo& child : element.children) {
          Define(child.name, [&] { Attributes(child, false); });
        }
      } else if (!element.children.empty()) {
        Define("children", [&] {
          Text("type", "array");
          Key("items");
          Object([&] { OneOf(element.children, false); });
        });
      }
    });
    NoOtherKeys();
  }
};

}  // namespace mjforge::spec

#endif  // MJFORGE_SPEC_SCHEMA_SECTIONS_H_
