#include <string>

#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

std::string Including(const std::string& file) {
  return "<mujoco>\n<include file=\"" + file + "\"/>\n</mujoco>\n";
}

TEST_CASE("includes are put in place, at any depth, relative to the first file") {
  Attaching files(
      "<mujoco>\n<include file=\"parts/settings.xml\"/>\n<worldbody>\n"
      "<body name=\"b\"><INCLUDE file=\"parts/geoms.xml\"/></body>\n"
      "</worldbody>\n</mujoco>\n");
  files.Write("parts/settings.xml",
              "<mujoco><default><geom condim=\"6\"/></default>"
              "<include file=\"parts/more.xml\"/></mujoco>");
  files.Write("parts/more.xml", "<any><compiler angle=\"radian\"/></any>");
  files.Write("parts/geoms.xml",
              "<mujocoinclude>\n<geom name=\"g\" type=\"box\" size=\"1 1 1\" euler=\"0 0 1.5\"/>\n"
              "<geom name=\"h\" size=\"1\"/>\n</mujocoinclude>");
  const model::Attachment& b = files.Get();
  REQUIRE(Names(b.bodies[0].parts) == "g h");
  CHECK(Said(b.bodies[0].parts[1].attributes) == "condim=6");
  CHECK(b.bodies[0].parts[0].X_BG.q.isApprox(model::FromEuler({0, 0, 1.5})));
  CHECK(b.bodies[0].parts[1].mark.line == 3);
}

TEST_CASE("an include that is missing, broken or empty is an error at its place") {
  Attaching files(Including("gone.xml"));
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'arm.xml' includes 'gone.xml', which cannot be read: No such "
        "file or directory [arm.xml:2:1 here]");
  files.Write("b.xml", Including("broken.xml"));
  files.Write("broken.xml", "<mujoco>\n<body>\n</mujoco>");
  CHECK(files.Try("", "b.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'b.xml' includes 'broken.xml', which is not an XML file: "
        "start-end tags mismatch [b.xml:2:1 here] [broken.xml:3:3 broken here]");
  files.Write("e.xml", Including("empty.xml"));
  files.Write("empty.xml", "<mujoco/>");
  CHECK(files.Try("", "e.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'e.xml' includes 'empty.xml', which contains no elements "
        "[e.xml:2:1 here]");
  files.Write("n.xml", "<mujoco><include/></mujoco>");
  CHECK(files.Try("", "n.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'n.xml' has an include without a file [n.xml:1:9 here]");
  files.Write("c.xml", "<mujoco><include file=\"arm.xml\"><body/></include></mujoco>");
  CHECK(files.Try("", "c.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'c.xml' has an include of 'arm.xml' that contains elements "
        "[c.xml:1:9 here]");
}

TEST_CASE("a cycle of includes and a second one of a file are errors") {
  Attaching files(Including("b.xml"));
  files.Write("b.xml", Including("arm.xml"));
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'b.xml' includes 'arm.xml', which is already open: a cycle "
        "[b.xml:2:1 here]");
  files.Write("twice.xml",
              "<mujoco>\n<include file=\"c.xml\"/>\n<include file=\"./c.xml\"/>\n</mujoco>");
  files.Write("c.xml", "<mujoco><worldbody/></mujoco>");
  CHECK(files.Try("", "twice.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/bad-include: 'twice.xml' includes './c.xml' a second time (MuJoCo includes "
        "each file only once; give the copy another name) [twice.xml:3:1 here] [twice.xml:2:1 "
        "first here]");
}

}  // namespace
}  // namespace mjforge::attach
