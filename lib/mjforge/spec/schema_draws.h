#ifndef MJFORGE_SPEC_SCHEMA_DRAWS_H_
#define MJFORGE_SPEC_SCHEMA_DRAWS_H_

// The definitions of the JSON Schema that describe distributions.

#include <initializer_list>
#include <string_view>

#include "mjforge/spec/fields.h"
#include "mjforge/spec/schema_writer.h"

namespace mjforge::spec {

// A quoted number is text, and so no expression.
inline constexpr const char* kExpressionPattern =
    "^(?![-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?$)";

class DrawSchema : protected SchemaWriter {
 protected:
  void Define(std::string_view name, const Body& body) {
    Key(name);
    Object(body);
  }

  void Expression() {
    Text("type", "string");
    Text("pattern", kExpressionPattern);
  }
  void ListOf(std::string_view definition) {
    Text("type", "array");
    Key("items");
    Object([&] { Ref(definition); });
  }
  void Draws() {
    for (const DistributionInfo& info : Distributions()) {
      Define(info.key, [&] { Draw(info, [] {}); });
    }
    Define("about", [this] { VectorForm("about", 3, 3); });
    Define("hsv", [this] { VectorForm("hsv", 3, 4); });
    Define("on_sphere", [this] {
      Text("type", "object");
      Key("properties");
      Object([this] { Define("on_sphere", [this] { Ref("number"); }); });
      Strings("required", {"on_sphere"});
      NoOtherKeys();
    });
    const auto real = [](const DistributionInfo& info) {
      return info.id != Distribution::kBernoulli;
    };
    const auto boolean = [](const DistributionInfo& info) {
      return info.id == Distribution::kBernoulli || info.arguments < 0;
    };
    const auto text = [](const DistributionInfo& info) { return info.arguments < 0; };
    const auto any = [](const DistributionInfo&) { return true; };
    DrawUnion("number_draw", real, {});
    DrawUnion("boolean_draw", boolean, {});
    DrawUnion("text_draw", text, {});
    DrawUnion("vector_draw", real, {"about", "hsv", "on_sphere"});
    DrawUnion("any_draw", any, {"about", "hsv", "on_sphere"});
  }

  void VectorForm(std::string_view key, int min_count, int max_count) {
    Text("type", "object");
    Key("properties");
    Object([&] {
      Define(key, [&] {
        AnyOf({[&] {
                 ListOf("number");
                 Count("minItems", min_count);
                 Count("maxItems", max_count);
               },
               [this] { Expression(); }});
      });
    });
    Strings("required", {key});
    NoOtherKeys();
  }

  template <typename Wanted>
  void DrawUnion(std::string_view name, Wanted wanted,
                 std::initializer_list<std::string_view> more) {
    Define(name, [&] {
      Key("anyOf");
      OpenList();
      for (const DistributionInfo& info : Distributions()) {
        if (wanted(info)) Object([&] { Ref(info.key); });
      }
      for (const std::string_view form : more) Object([&] { Ref(form); });
      CloseList();
    });
  }

  void DrawArguments(const DistributionInfo& info) {
    if (info.arguments < 0) {
      Text("type", "array");
      Count("minItems", 1);
      return;
    }
    const Body list = [&] {
      ListOf("number");
      Count("minItems", info.arguments);
      Count("maxItems", info.arguments);
    };
    if (info.arguments > 1) return list();
    AnyOf({[this] { Ref("number"); }, list});
  }

  void Draw(const DistributionInfo& info, const Body& more_properties) {
    Text("type", "object");
    Text("description", fmt::format("{}: {}", info.usage, info.doc));
    Key("properties");
    Object([&] {
      Define(info.key, [&] { DrawArguments(info); });
      if (!info.option.empty()) {
        Define(info.option, [&] {
          ListOf("number");
          Count("minItems", info.option == "weights" ? 1 : 2);
          if (info.option != "weights") {
            Count("maxItems", 2);
          }
        });
      }
      if (!info.flag.empty()) {
        Define(info.flag, [this] { Text("type", "boolean"); });
      }
      more_properties();
    });
    Strings("required", {info.key});
    NoOtherKeys();
  }
};

}  // namespace mjforge::spec

#endif  // MJFORGE_SPEC_SCHEMA_DRAWS_H_
