// Tests of `mjforge inspect`.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

const std::vector<std::string> kPinned = {"inspect", "crate.yaml", "--set", "height=0.15"};

std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_CASE_METHOD(CrateTest, "inspect shows parameters, parts, joints, bounds and mass") {
  const auto result = Run(kPinned);
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "crate: A box.\n"
        "\n"
        "parameter  spec  here  unit  doc\n"
        "height     0.15  0.15  m     Half the height.\n"
        "\n"
        "seed 0, index 0, attempt 0\n"
        "\n"
        "part        type  role  size          pos    kg\n"
        "crate_body  box   both  0.1 0.1 0.15  0 0 0  6\n"
        "\n"
        "joint         type\n"
        "crate_joint0  free\n"
        "\n"
        "bounds   -0.1 -0.1 -0.15 to 0.1 0.1 0.15 m\n"
        "mass     6 kg\n"
        "com      0 0 0 m\n"
        "inertia  0.065 0.065 0.04  0 0 0 kg m^2 (xx yy zz  xy xz yz)\n"
        "radius   0.141421 m about the z axis\n"
        "text     602 bytes of MJCF\n");
}

TEST_CASE_METHOD(CrateTest, "inspect says how long the text is, and how much of it are meshes") {
  folder().Write(
      "ring.yaml",
      "mjforge: 1\n"
      "name: ring\n"
      "parts:\n"
      "  - {name: body, type: lathe, profile: [[2cm, 0], [3cm, 0], [3cm, 1cm], [2cm, 1cm]]}\n");
  const std::string text = Run({"generate", "ring.yaml", "-o", "-"}).out;
  std::size_t meshes = 0;
  for (std::size_t at = text.find("    <mesh "); at != text.npos;
       at = text.find("    <mesh ", at + 1))
    meshes += text.find('\n', at) + 1 - at;
  CHECK(meshes > 1000);
  CHECK(Run({"inspect", "ring.yaml"})
            .out.ends_with("\ntext     " + std::to_string(text.size()) + " bytes of MJCF, " +
                           std::to_string(meshes) + " of them in meshes\n"));
  CHECK(Run({"inspect", "ring.yaml", "--json"})
            .out.find(",\"text_bytes\":" + std::to_string(text.size()) +
                      ",\"mesh_bytes\":" + std::to_string(meshes) + "}") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect shows a range as the spec has it, and the value drawn") {
  const auto first = Run({"inspect", "crate.yaml", "--seed", "7", "--index", "1"});
  CHECK(first.out.find("height     0.1 .. 0.2  0.1") != std::string::npos);
  CHECK(first.out.find("seed 7, index 1, attempt 0") != std::string::npos);
  CHECK(first.out != Run({"inspect", "crate.yaml", "--seed", "7", "--index", "2"}).out);
}

TEST_CASE_METHOD(CrateTest, "inspect refuses options of a spec for a file or a batch") {
  REQUIRE(Run({"generate", "crate.yaml", "-n", "2", "-o", "out", "-q"}).status == 0);
  for (const char* what : {"out", "out/crate_000000.xml"}) {
    const std::vector<std::vector<std::string>> options = {
        {"--seed", "9"}, {"--index", "1"}, {"--set", "height=0.15"}, {"--start", "zero"}};
    for (const std::vector<std::string>& option : options) {
      const auto result = Run(With({"inspect", what}, option));
      CHECK(result.status == 2);
      CHECK(result.out.empty());
      CHECK(result.err.find(std::string(what) + "' is shown as it is: --seed, ") !=
            std::string::npos);
    }
  }
}

TEST_CASE_METHOD(CrateTest, "inspect --json is one object") {
  const auto result = Run(With(kPinned, {"--json"}));
  CHECK(result.status == 0);
  CHECK(
      result.out.starts_with("{\"name\":\"crate\",\"description\":\"A box.\","
                             "\"spec\":\"crate.yaml\",\"spec_sha256\":\""));
  CHECK(result.out.find("\"parameters\":[{\"name\":\"height\",\"spec\":\"0.15\",\"value\":0.15,"
                        "\"unit\":\"m\",\"section\":\"\",\"doc\":\"Half the height.\"}]") !=
        std::string::npos);
  CHECK(result.out.find("\"aabb\":{\"min\":[-0.1,-0.1,-0.15],\"max\":[0.1,0.1,0.15]},"
                        "\"swept_aabb\":{\"min\":[-0.1,-0.1,-0.15],\"max\":[0.1,0.1,0.15]},"
                        "\"mass\":6,\"com\":[0,0,0],") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect --contains says whether a point is inside") {
  const auto contains = [&](const char* point) {
    const auto result = Run(With(kPinned, {"--contains", point}));
    CHECK(result.status == 0);
    return result.out;
  };
  CHECK(contains("0,0,0.149") == "inside\n");
  CHECK(contains("-0.1,0.1,0.15") == "inside\n");
  CHECK(contains("0,0,-0.151") == "outside\n");
  CHECK(Run(With(kPinned, {"--contains", "0,0,0", "--json"})).out == "{\"contains\":true}\n");
  const auto bad = Run(With(kPinned, {"--contains", "0,0"}));
  CHECK(bad.status == 2);
  CHECK(bad.err ==
        "mjforge: error: --contains: '0,0' is not of the form X,Y,Z\n"
        "  hint: see 'mjforge inspect --help'\n");
}

TEST_CASE_METHOD(CrateTest, "inspect of an MJCF file shows what MuJoCo compiled") {
  REQUIRE(Run({"generate", "crate.yaml", "--set", "height=0.15", "-q", "-o", "x.xml"}).status == 0);
  const auto result = Run({"inspect", "x.xml"});
  CHECK(result.status == 0);
  CHECK(result.out.find("mass     6 kg\n") != std::string::npos);
  CHECK(result.out.find("bounds   -0.1 -0.1 -0.15 to 0.1 0.1 0.15 m\n") != std::string::npos);
  CHECK(Run({"inspect", "x.xml", "--json"}).out.find("\"mass\":6,") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect of what is not there is a finding") {
  CHECK(Run({"inspect", "none.yaml"}).status == 3);
  const auto result = Run({"inspect", "none.xml"});
  CHECK(result.status == 3);
  CHECK(result.out.empty());
}

/// A gate with a sliding bolt that penetrates a post.
class GateTest : public harness::ProgramTest {
 protected:
  GateTest() {
    folder().Write("gate.xml", R"(<mujoco model="gate">
  <compiler angle="radian"/>
  <worldbody>
    <body name="frame">
      <freejoint name="free"/>
      <geom name="sill" type="box" size="0.5 0.05 0.02"/>
      <body name="post" pos="0.3 0 0.2">
        <geom name="pole" type="sphere" size="0.02" mass="0.5"/>
      </body>
      <body name="leaf" pos="-0.4 0 0.2" quat="0 0 0 1">
        <joint name="hinge" axis="0 0 1" limited="true" range="0 1"/>
        <geom name="panel" type="box" size="0.2 0.01 0.1" pos="-0.2 0 0"/>
        <body name="bolt" pos="-0.4 0 0">
          <joint name="slide" type="slide" axis="-1 0 0" limited="true" range="0 0.4"/>
          <joint name="loose" type="slide" axis="0 0 1"/>
          <geom name="bar" type="sphere" size="0.02" mass="0.1"/>
        </body>
      </body>
    </body>
  </worldbody>
  <sensor><jointpos name="angle" joint="hinge"/></sensor>
</mujoco>
)");
  }
};

TEST_CASE_METHOD(GateTest, "inspect of an MJCF file shows bodies, joints and what refers to them") {
  const auto result = Run({"inspect", "gate.xml"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "gate\n"
        "\n"
        "body   parent  pos         quat     geoms  kg   com       inertia, kg m^2\n"
        "frame  world   0 0 0                1      4    0 0 0     0.00386667 0.333867 0.336667  0 "
        "0 0\n"
        "post   frame   0.3 0 0.2            1      0.5  0 0 0     8e-05 8e-05 8e-05  0 0 0\n"
        "leaf   frame   -0.4 0 0.2  0 0 0 1  1      1.6  -0.2 0 0  0.00538667 0.0266667 0.0213867  "
        "0 0 0\n"
        "bolt   leaf    -0.4 0 0             1      0.1  0 0 0     1.6e-05 1.6e-05 1.6e-05  0 0 0\n"
        "\n"
        "joint  body   type   axis    range\n"
        "free   frame  free\n"
        "hinge  leaf   hinge  0 0 1   0 1\n"
        "slide  bolt   slide  -1 0 0  0 0.4\n"
        "loose  bolt   slide  0 0 1\n"
        "\n"
        "element  kind\n"
        "angle    sensor\n"
        "\n"
        "bounds   -0.5 -0.05 -0.02 to 0.5 0.05 0.3 m\n"
        "mass     6.2 kg\n"
        "com      -0.0274194 0 0.0709677 m\n"
        "inertia  0.0661235 0.521742 0.462488  0 0.0219355 0 kg m^2 (xx yy zz  xy xz yz)\n");
}

TEST_CASE_METHOD(GateTest, "inspect --sweep shows inside contacts and the box of all poses") {
  const auto result = Run({"inspect", "gate.xml", "--sweep"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  const auto sweep = result.out.find("yy zz  xy xz yz)\n");
  REQUIRE(sweep != std::string::npos);
  CHECK(result.out.substr(sweep + 17) ==
        "\n"
        "joint  at   body  geom  body  geom  mm deep\n"
        "slide  0.3  post  pole  bolt  bar   40\n"
        "\n"
        "held     loose, a slide without a range\n"
        "swept    -0.5 -0.05 -0.02 to 0.5 0.693177 0.3 m\n");
}

TEST_CASE_METHOD(GateTest, "inspect --sweep --json has the same as numbers") {
  const auto result = Run({"inspect", "gate.xml", "--sweep", "--json"});
  CHECK(result.status == 0);
  CHECK(result.out.find(R"({"name":"leaf","parent":"frame","pos":[-0.4,0,0.2],"quat":[0,0,0,1],)"
                        R"("mass":1.6,"com":[-0.2,0,0],"inertia":[)") != std::string::npos);
  CHECK(result.out.find(R"("elements":[{"kind":"sensor","name":"angle"}])") != std::string::npos);
  CHECK(result.out.find(R"("sweep":{"contacts":[{"joint":"slide","value":0.3,"body1":"post",)"
                        R"("geom1":"pole","body2":"bolt","geom2":"bar","depth":0.04}],)"
                        R"("held":["loose"],"aabb":{"min":[-0.5,)") != std::string::npos);
}

/// A tray on a rail that penetrates a stop, and a hand on the tray.
class CabinetTest : public harness::ProgramTest {
 protected:
  CabinetTest() {
    folder().Write("cabinet.yaml",
                   "mjforge: 1\n"
                   "name: cabinet\n"
                   "parts: [{name: back, type: box, size: [0.2, 0.01, 0.1], mass: 1}]\n"
                   "bodies:\n"
                   "  - name: left\n"
                   "    pos: [-0.1, 0.2, 0]\n"
                   "    parts: [{name: tray, type: sphere, size: 0.05, mass: 1}]\n"
                   "    joints: [{name: rail, type: slide, axis: [1, 0, 0], range: [0, 0.32]}]\n"
                   "  - name: arm\n"
                   "    parent: left\n"
                   "    pos: [0, 0.1, 0]\n"
                   "    quat: [0, 0, 0, 1]\n"
                   "    parts: [{name: hand, type: sphere, size: 0.01, mass: 1}]\n"
                   "    joints: [{name: wrist, type: ball, range: [0, 1]}]\n"
                   "  - name: right\n"
                   "    pos: [0.02, 0.2, 0]\n"
                   "    parts: [{name: stop, type: sphere, size: 0.05, mass: 1}]\n"
                   "    joints: [{name: turn, type: hinge, range: [0, 1]}]\n"
                   "contact: {exclude: [[cabinet, left]]}\n"
                   "mjcf:\n"
                   "  sensor: [{jointpos: {name: drawn, joint: rail}}]\n");
  }
};

TEST_CASE_METHOD(CabinetTest, "inspect of several bodies shows the tree and who has what") {
  const auto result = Run({"inspect", "cabinet.yaml"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "cabinet\n"
        "\n"
        "seed 0, index 0, attempt 0\n"
        "\n"
        "body           parent        pos         quat     kg  com    inertia, kg m^2\n"
        "cabinet                      0 0 0                1   0 0 0  0.00336667 0.0166667 "
        "0.0133667  0 0 0\n"
        "cabinet_left   cabinet       -0.1 0.2 0           1   0 0 0  0.001 0.001 0.001  0 0 0\n"
        "cabinet_arm    cabinet_left  0 0.1 0     0 0 0 1  1   0 0 0  4e-05 4e-05 4e-05  0 0 0\n"
        "cabinet_right  cabinet       0.02 0.2 0           1   0 0 0  0.001 0.001 0.001  0 0 0\n"
        "\n"
        "part          body           type    role  size          pos    kg\n"
        "cabinet_back  cabinet        box     both  0.2 0.01 0.1  0 0 0  1\n"
        "cabinet_tray  cabinet_left   sphere  both  0.05          0 0 0  1\n"
        "cabinet_hand  cabinet_arm    sphere  both  0.01          0 0 0  1\n"
        "cabinet_stop  cabinet_right  sphere  both  0.05          0 0 0  1\n"
        "\n"
        "joint           body           type   axis   range\n"
        "cabinet_joint0  cabinet        free\n"
        "cabinet_rail    cabinet_left   slide  1 0 0  0 0.32\n"
        "cabinet_wrist   cabinet_arm    ball          0 1\n"
        "cabinet_turn    cabinet_right  hinge  0 0 1  0 1\n"
        "\n"
        "element        kind      of\n"
        "               exclude   contact\n"
        "cabinet_drawn  jointpos  sensor\n"
        "\n"
        "bounds   -0.2 -0.01 -0.1 to 0.2 0.31 0.1 m\n"
        "mass     4 kg\n"
        "com      -0.045 0.175 0 m\n"
        "inertia  0.0529067 0.0310067 0.0752067  0.0145 0 0 kg m^2 (xx yy zz  xy xz yz)\n"
        "radius   0.326228 m about the z axis\n"
        "reach    -0.2 -0.01 -0.1 to 0.27 0.31 0.1 m with all positions of joints\n"
        "text     1979 bytes of MJCF\n");
}

TEST_CASE_METHOD(CabinetTest, "inspect --json of several bodies has poses, masses and sections") {
  const auto result = Run({"inspect", "cabinet.yaml", "--json"});
  CHECK(result.status == 0);
  CHECK(result.out.find(R"({"name":"cabinet_arm","parent":"cabinet_left","pos":[0,0.1,0],)"
                        R"("quat":[0,0,0,1],"mass":1,"com":[0,0,0],)"
                        R"("inertia":[4e-05,4e-05,4e-05,0,0,0],)") != std::string::npos);
  CHECK(result.out.find(R"("sections":{"contact":[{"kind":"exclude","name":""}],)"
                        R"("sensor":[{"kind":"jointpos","name":"cabinet_drawn"}]})") !=
        std::string::npos);
}

TEST_CASE_METHOD(CabinetTest, "inspect --sweep of a spec is by the joints of its bodies") {
  const auto result = Run({"inspect", "cabinet.yaml", "--sweep"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  const auto text = result.out.find(" bytes of MJCF\n");
  REQUIRE(text != std::string::npos);
  CHECK(result.out.substr(text + 15) ==
        "\n"
        "joint         at    body          geom          body           geom          mm deep\n"
        "cabinet_rail  0.12  cabinet_left  cabinet_tray  cabinet_right  cabinet_stop  100\n"
        "\n"
        "swept    -0.2 -0.01 -0.1 to 0.27 0.31 0.1 m\n");
}

TEST_CASE_METHOD(CabinetTest, "inspect --contains looks into every body") {
  const auto contains = [&](const char* point) {
    return Run({"inspect", "cabinet.yaml", "--contains", point}).out;
  };
  CHECK(contains("-0.1,0.24,0") == "inside\n");
  CHECK(contains("-0.1,0.305,0") == "inside\n");
  CHECK(contains("-0.1,0.28,0") == "outside\n");
}

TEST_CASE_METHOD(CrateTest, "inspect --sweep of an object whose joints move nothing inside") {
  const auto result = Run(With(kPinned, {"--sweep"}));
  CHECK(result.status == 0);
  CHECK(
      result.out.ends_with("radius   0.141421 m about the z axis\n"
                           "text     602 bytes of MJCF\n"
                           "\n"
                           "no contacts between bodies\n"
                           "\n"
                           "swept    -0.1 -0.1 -0.15 to 0.1 0.1 0.15 m\n"));
  CHECK(Run(With(kPinned, {"--sweep", "--json"}))
            .out.ends_with("\"sweep\":{\"contacts\":[],\"held\":[],\"aabb\":{\"min\":"
                           "[-0.1,-0.1,-0.15],\"max\":[0.1,0.1,0.15]}}}\n"));
}

TEST_CASE_METHOD(CrateTest, "inspect --sweep beside --contains is wrong usage") {
  const auto result = Run(With(kPinned, {"--sweep", "--contains", "0,0,0"}));
  CHECK(result.status == 2);
  CHECK(result.err ==
        "mjforge: error: --contains excludes --sweep\n"
        "  hint: see 'mjforge inspect --help'\n");
}

TEST_CASE_METHOD(CrateTest, "inspect --sweep of a file that MuJoCo refuses is a finding") {
  folder().Write("bad.xml", "<mujoco><worldbody><geom/></worldbody></mujoco>");
  const auto result = Run({"inspect", "bad.xml", "--sweep"});
  CHECK(result.status == 1);
  CHECK(result.out.empty());
}

}  // namespace
}  // namespace mjforge
