#include "mjforge/attach/attach.h"

#include <string>
#include <vector>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

const std::string kArm = Mjcf(
    "<body name=\"base\"><geom type=\"box\" size=\"1 1 1\"/>\n"
    "<body name=\"arm\"><joint name=\"swing\"/><geom size=\"1\"/></body></body>\n");

TEST_CASE("the first body is taken where none is asked for, with all below it") {
  Attaching files(kArm);
  const model::Attachment& arm = files.Get();
  CHECK(Names(arm.bodies) == "base arm");
  CHECK(arm.bodies[0].parent == -1);
  CHECK(arm.bodies[1].parent == 0);
  CHECK(arm.root_joints.empty());
  CHECK(files.Report().empty());
}

TEST_CASE("a body further down is taken by its name, and its joints are said") {
  Attaching files(kArm);
  const model::Attachment& arm = files.Get("arm");
  CHECK(Names(arm.bodies) == "arm");
  CHECK(arm.bodies[0].parent == -1);
  CHECK(arm.root_joints == std::vector<std::string>{"swing"});
  CHECK(Names(arm.bodies[0].joints) == "swing");
}

TEST_CASE("a file is read once, whatever changes on the disk, and a result is kept") {
  Attaching files(kArm);
  const model::Attachment* first = &files.Get("arm");
  files.Write("arm.xml", "no more");
  CHECK(&files.Get("arm") == first);
  CHECK(Names(files.Get("base").bodies) == "base arm");
}

TEST_CASE("findings come at every call, warnings, too") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom size=\"1\"/></body>\n", "<option timestep=\"0.01\"/>\n"));
  const std::string warning =
      "warning attach/not-carried: the option of 'arm.xml' is not carried over (it would apply to "
      "the whole model; if you want that, write it under `mjcf:` in the spec) [arm.xml:2:1 here]";
  files.Get();
  CHECK(files.OnlyFinding() == warning);
  files.Get();
  CHECK(files.OnlyFinding() == warning);
  files.Try("c");
  CHECK(files.Report() ==
        std::vector<std::string>{warning, "error attach/no-body: 'arm.xml' has no body 'c'"});
}

TEST_CASE("a missing file, a folder, and what is not MJCF are errors") {
  Attaching files;
  CHECK(files.Try() == nullptr);
  CHECK(files.OnlyFinding() ==
        "error model/file-not-found: cannot read 'arm.xml': No such file or directory");
  CHECK(files.Try("", "") == nullptr);
  CHECK(files.OnlyFinding() == "error yaml/cannot-read: cannot read '': it is a folder");
  files.Write("empty.xml", "");
  CHECK(files.Try("", "empty.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error mujoco/not-mjcf: 'empty.xml' cannot be attached: not an XML file: no document "
        "element found [empty.xml:1:1 here]");
  files.Write("cut.xml", "<mujoco>\n<worldbody>\n<body name=\"b\"");
  CHECK(files.Try("", "cut.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error mujoco/not-mjcf: 'cut.xml' cannot be attached: not an XML file: error parsing "
        "start element tag [cut.xml:3:14 here]");
  files.Write("robot.urdf", "<robot name=\"r\"/>");
  CHECK(files.Try("", "robot.urdf") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error mujoco/not-mjcf: 'robot.urdf' cannot be attached: the root element is <robot>, not "
        "<mujoco>: this is a URDF file (convert it to MJCF first: load it in MuJoCo and save it "
        "with mj_saveLastXML) [robot.urdf:1:2 here]");
}

TEST_CASE("a body that is not there is an error with the nearest name") {
  Attaching files(kArm);
  CHECK(files.Try("amr") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/no-body: 'arm.xml' has no body 'amr' (did you mean 'arm'?)");
  CHECK(files.Try("world") == nullptr);
  CHECK(files.OnlyFinding() == "error attach/no-body: 'arm.xml' has no body 'world'");
  files.Write("bare.xml", Mjcf("<geom size=\"1\"/>"));
  CHECK(files.Try("", "bare.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/no-body: 'bare.xml' has no body (elements directly in its worldbody cannot "
        "be attached; put them into a body) [bare.xml:1:1 here]");
}

TEST_CASE("what MuJoCo refuses is told with its reason and place") {
  Attaching files(
      Mjcf("<body name=\"b\">\n  <geom name=\"g\" type=\"box\" size=\"1 1\"/>\n</body>\n"));
  CHECK(files.Try() == nullptr);
  constexpr bool kOlder = mjVERSION_HEADER < 300;
  CHECK(files.OnlyFinding() == "error mujoco/error: MuJoCo refused geom 'g' of 'arm.xml': " +
                                   std::string(kOlder
                                                   ? "sizes must be positive in object 'g' (id = 0)"
                                                   : "size 2 must be positive in geom") +
                                   " [arm.xml:4:3 here]");
  files.Write("unnamed.xml", Mjcf("<body>\n<joint limited=\"true\" range=\"1 0\"/>\n"
                                  "<geom size=\"1\"/></body>\n"));
  CHECK(files.Try("", "unnamed.xml") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error mujoco/error: MuJoCo refused the joint on line 4 of 'unnamed.xml': range[0] should "
        "be smaller than range[1] in joint" +
            std::string(kOlder ? " '' (line 4) (id = 0)" : "") + " [unnamed.xml:4:1 here]");
}

TEST_CASE("numbers that are not finite are errors though MuJoCo loads them") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom name=\"g\" size=\"1\" friction=\"nan 0 0\"/></body>\n"));
  CHECK(files.Try() == nullptr);
  CHECK(files.Report().back() ==
        "error model/bad-value: geom 'g' of 'arm.xml' has a friction that is not a finite number "
        "[arm.xml:3:16 here]");
}

TEST_CASE("elements nested without end are refused") {
  std::string deep;
  for (int i = 0; i < 3000; ++i) deep += "<body>";
  for (int i = 0; i < 3000; ++i) deep += "</body>";
  Attaching files(Mjcf(deep));
  CHECK(files.Try() == nullptr);
  REQUIRE(files.Report().size() == 1);
  CHECK(files.OnlyFinding().starts_with(
      "error mujoco/not-mjcf: 'arm.xml' nests elements more than 1000 deep"));
}

TEST_CASE("what holds for the whole model is named") {
  Attaching files(Mjcf("<body name=\"b\" mocap=\"true\"><geom size=\"1\"/></body>\n",
                       "<size nkey=\"1\"/><visual/><statistic extent=\"1\"/>\n"
                       "<option><flag gravity=\"disable\"/></option>\n"
                       "<custom><numeric name=\"n\" data=\"1\"/></custom>\n"
                       "<keyframe><key name=\"k\"/></keyframe>\n"));
  files.Get();
  const std::vector<std::string> report = files.Report();
  REQUIRE(report.size() == 4);
  CHECK(report[0].starts_with("warning attach/not-carried: the option of 'arm.xml'"));
  CHECK(report[1].starts_with("warning attach/not-carried: the custom data of 'arm.xml'"));
  CHECK(report[2] ==
        "warning attach/not-carried: the keyframes of 'arm.xml' are not carried over (a keyframe "
        "is a state of the whole model) [arm.xml:5:1 here]");
  CHECK(report[3] ==
        "warning attach/not-carried: body 'b' of 'arm.xml' is not a mocap body where it is "
        "attached (a mocap body cannot be part of an object) [arm.xml:7:1 here]");
}

TEST_CASE("planes and height fields are errors, skins warnings") {
  Attaching files(
      Mjcf("<body name=\"b\"><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>"
           "<geom name=\"floor\" type=\"plane\" size=\"1 1 1\"/>\n"
           "<geom type=\"hfield\" hfield=\"hills\"/></body>\n"
           "<body name=\"c\"><geom size=\"1\"/></body>\n",
           "<asset><hfield name=\"hills\" nrow=\"2\" ncol=\"2\" size=\"1 1 1 1\"/>\n"
           "<skin name=\"cover\" vertex=\"0 0 0 1 0 0 0 1 0\" face=\"0 1 2\">"
           "<bone body=\"c\" bindpos=\"0 0 0\" bindquat=\"1 0 0 0\" vertid=\"0 1 2\" "
           "vertweight=\"1 1 1\"/></skin></asset>\n"));
  CHECK(files.Try("b") == nullptr);
  CHECK(files.Report() ==
        std::vector<std::string>{
            "error attach/not-carried: geom 'floor' of 'arm.xml' is a plane, which cannot be part "
            "of an object (planes and height fields belong to the world; attach a body without "
            "one) [arm.xml:5:68 here]",
            "error attach/not-carried: the geom on line 6 of 'arm.xml' is a height field, which "
            "cannot be part of an object (planes and height fields belong to the world; attach a "
            "body without one) [arm.xml:6:1 here]"});
  files.Get("c");
  CHECK(files.OnlyFinding() ==
        "warning attach/not-carried: skin 'cover' of 'arm.xml' is not carried over (a skin has no "
        "effect on motion; the bodies are shown without it) [arm.xml:3:1 here]");
}

#if mjVERSION_HEADER < 300
TEST_CASE("bodies that a composite makes are taken, and marked where it stands") {
  Attaching files;
  files.Write("grid.xml",
              Mjcf("<body name=\"b\">\n<composite prefix=\"P\" type=\"grid\" count=\"2 2 1\" "
                   "spacing=\"0.1\"><geom size=\"0.02\"/></composite></body>\n"));
  const model::Attachment& grid = files.Get("b", "grid.xml");
  CHECK(Names(grid.bodies) == "b PB0_0 PB0_1 PB1_0 PB1_1");
  CHECK(grid.bodies[2].mark.line == 4);
  CHECK(Names(grid.bodies[1].joints) == "PJ0_0_0 PJ1_0_0 PJ2_0_0");
}
#endif  // later ones have no grids

}  // namespace
}  // namespace mjforge::attach
