#include <catch2/catch.hpp>

#include <set>
#include <string>

#include "mjforge/spec/spec.h"

using mjforge::spec::ElementInfo;
using mjforge::spec::FieldInfo;

TEST_CASE("every field has a meaning, a unique key and sound bounds", "[fields]") {
  for (const ElementInfo* element : mjforge::spec::AllElements()) {
    std::set<std::string_view> keys;
    CHECK(!element->doc.empty());
    for (const FieldInfo& field : element->fields) {
      INFO(element->name << "." << field.key);
      CHECK(keys.insert(field.key).second);
      CHECK(field.doc.ends_with("."));
      CHECK(field.min_count <= field.max_count);
      CHECK(field.lower <= field.upper);
      CHECK((field.kind == mjforge::spec::FieldKind::kWord) ==
            (!field.words.empty() && field.key != "joints"));
    }
  }
}

TEST_CASE("the reference says that bodies may move freely", "[fields]") {
  const std::string reference = mjforge::spec::FieldReference();
  CHECK(reference.find("| `joints` | free, none or list of joints |  |  | free |") !=
        std::string::npos);
  CHECK(reference.find("| `joints` | free, none or list of joints |  |  | none |") !=
        std::string::npos);
}

TEST_CASE("the reference names every key, distribution, function and unit", "[fields]") {
  const std::string reference = mjforge::spec::FieldReference();
  for (const ElementInfo* element : mjforge::spec::AllElements()) {
    for (const FieldInfo& field : element->fields) {
      CHECK(reference.find("| `" + std::string(field.key) + "`") != std::string::npos);
    }
  }
  for (const auto& distribution : mjforge::spec::Distributions()) {
    CHECK(reference.find("`" + std::string(distribution.usage) + "`") != std::string::npos);
  }
}
