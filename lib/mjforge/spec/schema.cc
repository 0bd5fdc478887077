// The JSON Schema of a spec (draft-07), from the field table: what an editor
// needs to complete and check. It checks structure; names, expressions and
// references are checked by the parser alone.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <fmt/format.h>

#include "mjforge/spec/schema_sections.h"
#include "mjforge/spec/spec.h"

namespace mjforge::spec {
namespace {

constexpr const char* kNamePattern = "^[A-Za-z][A-Za-z0-9_]*$";
class SpecSchema : private SectionSchema {
 public:
  std::string Write() {
    Object([this] {
      Text("$schema", "http://json-schema.org/draft-07/schema#");
      Text("title", "mjforge object spec");
      Text("description", ObjectElement().doc);
      Text("type", "object");
      Properties(ObjectElement());
      Strings("required", {"mjforge"});
      SpecOrLibrary();
      Key("definitions");
      Object([this] { Definitions(); });
    });
    return Finish();
  }

 private:
  void Properties(const ElementInfo& element) {
    Key("properties");
    Object([&] {
      for (const FieldInfo& field : element.fields) {
        Key(field.key);
        Object([&] { Field(field); });
      }
    });
    NoOtherKeys();
  }

  void Describe(const FieldInfo& field) {
    std::string text(field.doc);
    if (!field.unit.empty()) text += fmt::format(" Unit: {}.", field.unit);
    if (!field.default_text.empty()) text += fmt::format(" Default: {}.", field.default_text);
    Text("description", text);
  }

  void Field(const FieldInfo& field) {
    Describe(field);
    switch (field.slot) {
      case Slot::kNumber:
        return IsBounded(field) ? Number(field) : Ref("number");
      case Slot::kInteger:
        return AnyOf({[&] { Literal(field, "integer"); }, [this] { Expression(); },
                      [this] { Ref("number_draw"); }});
      case Slot::kBoolean:
        return Ref("boolean");
      case Slot::kWord:
        return Word(field);
      case Slot::kText:
        return Ref("text");
      case Slot::kNumbers:
        return IsBounded(field) ? Numbers(field) : Ref(NumbersName(field));
      case Slot::kPoints:
        return Points(field);
      case Slot::kPlainText:
        return PlainText(field);
      case Slot::kFormat:
        Count("const", 1);
        return;
      default:
        return Structure(field);
    }
  }

  static bool IsBounded(const FieldInfo& field) {
    return std::isfinite(field.lower) || std::isfinite(field.upper);
  }
  static std::string NumbersName(const FieldInfo& field) {
    return fmt::format("numbers_{}_{}", field.min_count, field.max_count);
  }
  void Number(const FieldInfo& field) {
    AnyOf({[&] { Literal(field, "number"); }, [this] { Expression(); },
           [this] { Ref("number_draw"); }});
  }

  void Literal(const FieldInfo& field, std::string_view type) {
    Text("type", type);
    if (std::isfinite(field.lower))
      Bound(field.above ? "exclusiveMinimum" : "minimum", field.lower);
    if (std::isfinite(field.upper)) Bound("maximum", field.upper);
  }
  void Word(const FieldInfo& field) {
    AnyOf({[&] {
             Key("enum");
             OpenList();
             std::string_view words = field.words;
             while (!words.empty()) {
               const auto end = std::min(words.find(' '), words.size());
               String(words.substr(0, end));
               words.remove_prefix(std::min(end + 1, words.size()));
             }
             CloseList();
           },
           [this] {
             Text("type", "string");
             Text("pattern", "\\$\\{");
           },
           [this] { Ref("text_draw"); }});
  }
  void NumberList(const FieldInfo& field) {
    Text("type", "array");
    Key("items");
    Object([&] {
      AnyOf({[&] { Literal(field, "number"); }, [this] { Expression(); },
             [this] { Ref("number_draw"); }});
    });
    Count("minItems", field.min_count);
    Count("maxItems", field.max_count);
  }
  void Numbers(const FieldInfo& field) {
    if (field.min_count == 1) {
      AnyOf({[&] { NumberList(field); }, [&] { Literal(field, "number"); },
             [this] { Expression(); }, [this] { Ref("vector_draw"); }});
    } else {
      AnyOf({[&] { NumberList(field); }, [this] { Expression(); }, [this] { Ref("vector_draw"); }});
    }
  }
  void Points(const FieldInfo& field) {
    Text("type", "array");
    Count("minItems", field.min_count);
    Key("items");
    Object([this] {
      AnyOf({[this] {
               Text("type", "array");
               Key("items");
               Object([this] { Ref("number"); });
               Count("minItems", 2);
               Count("maxItems", 2);
             },
             [this] { Expression(); }, [this] { Ref("vector_draw"); }});
    });
  }
  void PlainText(const FieldInfo& field) {
    if (field.id == Key::kName) {
      Text("type", "string");
      Text("pattern", kNamePattern);
    } else {
      // `unit: 1` is text to us and a number to a reader of YAML.
      AnyOf({[this] { Text("type", "string"); }, [this] { Text("type", "number"); }});
    }
  }

  void MapOf(std::string_view definition) {
    Text("type", "object");
    Key("patternProperties");
    Object([&] { Define(kNamePattern, [&] { Ref(definition); }); });
    NoOtherKeys();
  }

  void Structure(const FieldInfo& field) {
    switch (field.slot) {
      case Slot::kParameters:
        return MapOf("parameter");
      case Slot::kOverrides:
        return MapOf("value");
      case Slot::kMaterials:
        return MapOf("material");
      case Slot::kLoops:
        return MapOf("number");
      case Slot::kDefaults:
        return Ref("defaults");
      case Slot::kTexture:
        return Ref("texture");
      case Slot::kPose:
        return Ref("frame");
      case Slot::kParts:
        return ListOf("part");
      case Slot::kSites:
        return ListOf("site");
      case Slot::kBodies:
        return ListOf("body");
      case Slot::kContact:
        return Ref("contacts");
      case Slot::kExcludes:
        return Excludes();
      case Slot::kBodyPair:
        return BodyPair();
      case Slot::kSections:
        return SectionProperties();
      case Slot::kChecks:
        return Ref("checks");
      case Slot::kSilence:
        return Silence();
      case Slot::kCondition:
        return Ref("condition");
      case Slot::kConditions:
        return AnyOf({[this] { Ref("condition"); }, [this] { ListOf("condition"); }});
      case Slot::kImports:
        return AnyOf({[this] { Text("type", "string"); },
                      [this] {
                        Text("type", "array");
                        Key("items");
                        Object([this] { Text("type", "string"); });
                      }});
      case Slot::kJoints:
        return AnyOf({[this] { Strings("enum", {"free", "none"}); }, [this] { ListOf("joint"); }});
      case Slot::kFields:
        return Defaults(field.id == Key::kPart   ? PartElement()
                        : field.id == Key::kSite ? SiteElement()
                                                 : JointElement());
      default:
        return;
    }
  }

  void Silence() {
    Text("type", "object");
    Key("properties");
    Object([this] {
      for (const diag::CodeInfo& info : diag::AllCodes()) {
        if (CanBeSilenced(info.code)) Define(info.name, [this] { Text("type", "string"); });
      }
    });
    NoOtherKeys();
  }

  // The element's own fields, none of them required.
  void Defaults(const ElementInfo& element) {
    Text("type", "object");
    SchemaWriter::Key("properties");
    Object([&] {
      for (const FieldInfo& field : element.fields) {
        Define(field.key, [&] { Ref(fmt::format("{}/properties/{}", element.name, field.key)); });
      }
    });
    NoOtherKeys();
  }

  // A file with a name and parts or bodies is a spec; one with neither is for `import:`.
  void SpecOrLibrary() {
    AnyOf({[this] {
             Strings("required", {"name"});
             AnyOf({[this] { Strings("required", {"parts"}); },
                    [this] { Strings("required", {"bodies"}); }});
           },
           [this] {
             Key("not");
             Object([this] {
               AnyOf({[this] { Strings("required", {"name"}); },
                      [this] { Strings("required", {"parts"}); },
                      [this] { Strings("required", {"bodies"}); }});
             });
           }});
  }

  void Element(const ElementInfo& element, const Body& more) {
    Element(element, element.name, more);
  }
  void Element(const ElementInfo& element, std::string_view definition, const Body& more) {
    Key(definition);
    Object([&] {
      Text("type", "object");
      Text("description", element.doc);
      Properties(element);
      more();
    });
  }

  void Definitions() {
    Values();
    Draws();
    NumberLists();
    Parameter();
    Element(MaterialElement(), [] {});
    Element(TextureElement(), [this] {
      AnyOf({[this] { Strings("required", {"builtin"}); },
             [this] { Strings("required", {"file"}); }});
    });
    Element(PartElement(), [this] {
      AnyOf({[this] { Strings("required", {"name"}); },
             [this] {
               Strings("required", {"frame", "parts"});
             }});
    });
    Element(FrameElement(), [] {});
    Element(SiteElement(), [this] { Strings("required", {"name"}); });
    Element(JointElement(), [this] { Strings("required", {"name"}); });
    Element(BodyElement(), [this] { Strings("required", {"name"}); });
    // `contact` alone is the definition of MJCF's section.
    Element(ContactElement(), "contacts", [] {});
    Element(ExcludeElement(), [this] { Strings("required", {"bodies"}); });
    Element(DefaultsElement(), [] {});
    Element(ChecksElement(), [] {});
    SectionDefinitions();
  }

  void Values() {
    Define("number", [this] {
      AnyOf({[this] { Text("type", "number"); }, [this] { Expression(); },
             [this] { Ref("number_draw"); }});
    });
    Define("boolean", [this] {
      AnyOf({[this] { Text("type", "boolean"); }, [this] { Expression(); },
             [this] { Ref("boolean_draw"); }});
    });
    Define("text", [this] {
      AnyOf({[this] { Text("type", "string"); }, [this] { Ref("text_draw"); }});
    });
    Define("condition", [this] {
      AnyOf({[this] { Text("type", "boolean"); }, [this] { Expression(); }});
    });
    Define("value", [this] {
      AnyOf({[this] {
               Key("type");
               OpenList();
               for (const std::string_view type : {"number", "boolean", "string"}) String(type);
               CloseList();
             },
             [this] {
               ListOf("number");
               Count("minItems", 2);
               Count("maxItems", 4);
             },
             [this] { Ref("any_draw"); }});
    });
  }

  // One definition for each length that some field without bounds has.
  void NumberLists() {
    std::set<std::string> done;
    for (const ElementInfo* element : AllElements()) {
      for (const FieldInfo& field : element->fields) {
        if (field.slot != Slot::kNumbers || IsBounded(field)) continue;
        const std::string name = NumbersName(field);
        if (done.insert(name).second) Define(name, [&] { Numbers(field); });
      }
    }
  }

  void DocAndUnit() {
    for (const std::string_view key : {"doc", "unit"}) {
      const FieldInfo* field = ParameterElement().Find(key);
      Define(key, [&] { Field(*field); });
    }
  }

  // A value, or the long form: a value or a distribution beside doc and unit.
  void Parameter() {
    Define("parameter", [this] {
      Text("description", ParameterElement().doc);
      Key("anyOf");
      OpenList();
      Object([this] { Ref("value"); });
      Object([this] {
        Text("type", "object");
        Key("properties");
        Object([this] {
          Define("value", [this] { Ref("value"); });
          DocAndUnit();
        });
        Strings("required", {"value"});
        NoOtherKeys();
      });
      for (const DistributionInfo& info : Distributions()) {
        Object([&] { Draw(info, [this] { DocAndUnit(); }); });
      }
      for (const std::string_view form : {"about", "hsv", "on_sphere"}) {
        Object([&] {
          Text("type", "object");
          Strings("required", {form});
        });
      }
      CloseList();
    });
  }
};

}  // namespace

std::string JsonSchema() { return SpecSchema().Write(); }

}  // namespace mjforge::spec
