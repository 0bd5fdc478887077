#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/spec/mjcf_sections.h"

namespace mjforge::spec {
namespace {

using Attributes = std::set<std::string>;

/// mj_printSchema's tree: "sensor/jointpos" with its attributes.
std::map<std::string, Attributes> Schema() {
  std::vector<char> text(200'000);
  REQUIRE(mj_printSchema(nullptr, text.data(), static_cast<int>(text.size()), 0, 0) > 0);
  std::map<std::string, Attributes> schema;
  std::vector<std::string> path;
  std::istringstream lines(text.data());
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    std::istringstream words(line);
    std::string word;
    // Attributes stand in one column; what begins before it is an element.
    if (indent < 30) {
      words >> word;
      if (indent == 0) continue;
      path.resize(indent / 3 > 0 ? indent / 3 - 1 : 0);  // the root is none of a path
      path.push_back(word);
      words >> word;  // (*)
    }
    std::string name;
    for (const std::string& step : path) name += (name.empty() ? "" : "/") + step;
    Attributes& attributes = schema[name];
    while (words >> word) attributes.insert(word);
  }
  return schema;
}

Attributes Of(const ElementInfo& element) {
  Attributes attributes;
  for (const FieldInfo& field : element.fields) attributes.emplace(field.key);
  return attributes;
}

/// Our own of `ours` as this MuJoCo has them. The language is MuJoCo 2.2's: later ones have more,
/// and lack what stands in kRemoved.
bool Agree(const Attributes& ours, Attributes theirs) {
  theirs.erase("class");
  if (mjVERSION_HEADER < 230) return ours == theirs;
  static const Attributes kRemoved = {"apirate",       "collision", "mpr_iterations",
                                      "mpr_tolerance", "passive",   "sensornoise"};
  return std::ranges::all_of(ours, [&](const std::string& attribute) {
    return theirs.contains(attribute) || kRemoved.contains(attribute);
  });
}

}  // namespace

TEST_CASE("the sections have the elements and attributes of MuJoCo's own schema", "[sections]") {
  const auto schema = Schema();
  REQUIRE(schema.size() > 100);
  std::set<std::string> covered;
  for (const SectionInfo& section : Sections()) {
    for (const ElementInfo& element : section.elements) {
      const std::string path = section.is_element
                                   ? std::string(section.name)
                                   : std::string(section.name) + "/" + std::string(element.name);
      INFO(path);
      REQUIRE(schema.contains(path));
      CHECK(Agree(Of(element), schema.at(path)));
      covered.insert(path);
      for (const ElementInfo& child : element.children) {
        const std::string inner = path + "/" + std::string(child.name);
        INFO(inner);
        REQUIRE(schema.contains(inner));
        CHECK(Agree(Of(child), schema.at(inner)));
        covered.insert(inner);
      }
    }
  }
  // And none is forgotten, but for the one that MuJoCo 3 refuses.
  for (const auto& [path, attributes] : schema) {
    const std::string section = path.substr(0, path.find('/'));
    if (FindSection(section) == nullptr || path == section) continue;
    INFO(path);
    if (mjVERSION_HEADER < 230) CHECK(covered.contains(path) == (path != "equality/distance"));
  }
}

TEST_CASE("cameras and lights have MuJoCo's attributes, but for poses written otherwise",
          "[sections]") {
  const auto schema = Schema();
  for (const std::string name : {"camera", "light"}) {
    Attributes theirs = schema.at("(world)body/" + name);
    for (const char* pose : {"axisangle", "xyaxes", "zaxis", "euler"}) theirs.erase(pose);
    CHECK(Agree(Of(*FindBodyChild(name)), theirs));
  }
}

TEST_CASE("what refers to an element says which kind", "[sections]") {
  const auto refers = [](const char* section, const char* element, const char* key) {
    return FindSection(section)->Find(element)->Find(key)->refers;
  };
  CHECK(refers("sensor", "jointpos", "joint") == "joint");
  CHECK(refers("sensor", "framepos", "refname") == "@reftype");
  CHECK(refers("contact", "pair", "geom2") == "geom");
  CHECK(refers("actuator", "general", "cranksite") == "site");
  CHECK(refers("sensor", "user", "datatype") == "");
}

}  // namespace mjforge::spec
