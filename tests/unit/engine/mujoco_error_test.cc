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
