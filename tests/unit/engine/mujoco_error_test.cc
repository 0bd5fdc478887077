#include "mjforge/engine/mujoco_error.h"

#include <catch2/catch.hpp>

namespace mjforge::engine {
namespace {

TEST_CASE("a compiler's error says its reason and line") {
  const Refusal refusal = ParseRefusal(
      "Error: mesh 'q' not found in geom 1\nObject name = , id = 1, line = 14, column = -1");
  CHECK(refusal.reason == "mesh 'q' not found in geom 1");
  CHECK(refusal.line == 14);
}

TEST_CASE("a reader's error says its reason and line") {
  const Refusal refusal = ParseRefusal(
      "XML Error: Schema violation: unrecognized attribute: 'sze'\n\n"
      "Element 'geom', line 3\n");
  CHECK(refusal.reason == "Schema violation: unrecognized attribute: 'sze'");
  CHECK(refusal.line == 3);
}

TEST_CASE("an error without a place has line 0") {
  const Refusal refusal = ParseRefusal("Error: engine error: Stack overflow");
  CHECK(refusal.reason == "engine error: Stack overflow");
  CHECK(refusal.line == 0);
}

TEST_CASE("an error of a sensor is on the line of the sensor of that name") {
  const std::string message =
      "Error: negative noise in sensor 'p' (id = 0)\nObject name = p, id = 0";
  const auto line = [&](std::string_view xml) { return ParseRefusal(message, xml).line; };
  CHECK(line("<mujoco>\n<body name=\"p\"/>\n<sensor>\n<jointpos name=\"p\"/></sensor>\n"
             "<worldbody><body name=\"p\"/></worldbody></mujoco>\n") == 4);
  CHECK(line("<mujoco><sensor>\n</sensor><sensor>\n<jointpos name='p'/></sensor></mujoco>") == 3);
  CHECK(line("<mujoco><sensor><jointpos name=\"pp\"/></sensor><body name=\"p\"/></mujoco>") == 0);
  const auto line_of = [](std::string_view said) {
    return ParseRefusal(said, "<sensor><a name=\"\"/><a name=\"p\"/></sensor>").line;
  };
  CHECK(line_of("Error: x in sensor\nObject name = , id = 0") == 0);
  CHECK(line_of("Error: x in text\nObject name = p, id = 0") == 0);
  CHECK(ParseRefusal(message).line == 0);
}

TEST_CASE("a text of several lines becomes one without final stop") {
  CHECK(OneLine("  a\n b.\n\n") == "a b");
  CHECK(OneLine("") == "");
}

TEST_CASE("an element is called by its tag and name") {
  const std::string xml = "<mujoco>\n  <geom name=\"head\" size=\"1\"/>\n  <geom/>\n</mujoco>\n";
  CHECK(ElementOnLine(xml, 2) == "geom 'head'");
  CHECK(ElementOnLine(xml, 3) == "the geom on line 3");
  CHECK(ElementOnLine(xml, 0) == "the model");
  CHECK(ElementOnLine(xml, 99) == "the model");
}

}  // namespace
}  // namespace mjforge::engine
