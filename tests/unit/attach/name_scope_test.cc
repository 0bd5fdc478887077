#include "mjforge/attach/name_scope.h"

#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

TEST_CASE("a name is made of letters, digits and _") {
  CHECK(MakeName("arm_2") == "arm_2");
  CHECK(MakeName("left-arm.2") == "left_arm_2");
  CHECK(MakeName("2nd") == "x2nd");
  CHECK(MakeName("_a") == "x_a");
  CHECK(MakeName("\xc3\xa4rm") == "x__rm");
  CHECK(MakeName("").empty());
}

TEST_CASE("elements without a name are called by their body and number") {
  Attaching files(
      Mjcf("<body><geom size=\"1\"/></body>\n"
           "<body><geom name=\"a-b\" size=\"1\"/><geom size=\"1\"/><geom name=\"body1_geom1\" "
           "size=\"1\"/><site/><camera/><light/>\n"
           "<body name=\"in/ner\"><joint/><joint name=\"k\" axis=\"1 0 0\"/><joint axis=\"0 1 0\"/>"
           "<geom size=\"1\"/></body></body>\n"));
  CHECK(Names(files.Get().bodies) == "body0");
  files.Write("named.xml",
              Mjcf("<body name=\"o\"><body><geom name=\"a-b\" size=\"1\"/><geom size=\"1\"/>"
                   "<geom name=\"body1_geom1\" size=\"1\"/><site/><camera/><light/>\n"
                   "<body name=\"in/ner\"><joint/><joint name=\"k\" axis=\"1 0 0\"/>"
                   "<joint axis=\"0 1 0\"/><geom size=\"1\"/></body></body></body>\n"));
  const model::Attachment& o = files.Get("o", "named.xml");
  REQUIRE(Names(o.bodies) == "o body1 in_ner");
  CHECK(Names(o.bodies[1].parts) == "a_b body1_geom2 body1_geom1");
  CHECK(Names(o.bodies[1].sites) == "body1_site0");
  CHECK(Names(o.bodies[1].elements) == "body1_camera0 body1_light0");
  CHECK(Names(o.bodies[2].joints) == "in_ner_joint0 k in_ner_joint2");
}

TEST_CASE("names that are made equal are an error at both places") {
  Attaching files(
      Mjcf("<body name=\"b\">\n<geom name=\"a-b\" size=\"1\"/>\n"
           "<geom name=\"a.b\" size=\"1\"/>\n<site name=\"a_b\"/></body>\n"));
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding() ==
        "error model/duplicate-name: geom 'a-b' and geom 'a.b' of 'arm.xml' both get the name "
        "'a_b' (names are made of letters, digits and _; rename one of them) [arm.xml:5:1 here] "
        "[arm.xml:4:1 and here]");
}

}  // namespace
}  // namespace mjforge::attach
