// Loader::Load: any MJCF file.

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {
namespace {

using harness::TemporaryFolder;

struct Result {
  std::optional<CompiledModel> model;
  diag::Sources sources;
  diag::Findings findings;
};

Result LoadFile(const std::filesystem::path& file) {
  static Loader loader;
  Result result;
  result.model = loader.Load(file, result.sources, result.findings);
  return result;
}

/// Loads a text as the file m.xml of a folder.
Result LoadText(const TemporaryFolder& folder, const std::string& text) {
  std::ofstream(folder.path() / "m.xml", std::ios::binary) << text;
  return LoadFile(folder.path() / "m.xml");
}

/// The only finding as "line:column: code: message".
std::string Only(const Result& result) {
  REQUIRE(result.findings.size() == 1);
  const diag::Finding& f = result.findings[0];
  return std::to_string(f.mark.line) + ":" + std::to_string(f.mark.column) + ": " +
         std::string(diag::CodeName(f.code)) + ": " + f.message;
}

constexpr const char* kArm = R"(<mujoco model="arm">
  <compiler angle="radian"/>
  <worldbody>
    <geom name="floor" type="plane" size="9 9 1"/>
    <body name="base" pos="0 0 1">
      <joint name="free" type="free"/>
      <geom type="box" size="0.1 0.2 0.3" mass="2"/>
      <geom type="sphere" size="5" contype="0" conaffinity="0" mass="0"/>
      <body name="tip" pos="1 0 0" quat="0.7071067811865476 0 0 0.7071067811865476">
        <joint name="turn" type="hinge" axis="0 2 0" limited="true" range="-1 1"/>
        <geom type="capsule" size="0.1 0.4" mass="1"/>
        <site name="end"/>
      </body>
    </body>
  </worldbody>
</mujoco>
)";

TEST_CASE("a model is told as MuJoCo compiled it") {
  const TemporaryFolder folder;
  const Result result = LoadText(folder, kArm);
  REQUIRE(result.findings.empty());
  REQUIRE(result.model);
  CHECK(result.model->geoms == 4);
  CHECK(result.model->joints == 2);
  CHECK(result.model->sites == 1);
  CHECK(result.model->body_geoms == std::vector<int>{2, 1});
  const model::Object& m = result.model->object;
  CHECK(m.name == "arm");
  REQUIRE(m.bodies.size() == 2);
  CHECK(m.bodies[0].name == "base");
  CHECK(m.bodies[0].parent == -1);
  REQUIRE(m.bodies[0].parts.size() == 2);
  CHECK(m.bodies[0].parts[0].shape.size == Eigen::Vector3d(0.1, 0.2, 0.3));
  CHECK(m.bodies[0].parts[0].role == model::Role::kCollision);
  CHECK(m.bodies[0].parts[1].role == model::Role::kVisual);
  CHECK(m.bodies[1].name == "tip");
  CHECK(m.bodies[1].parent == 0);
  CHECK(m.bodies[1].mass_properties.mass == 1);
  REQUIRE(m.bodies[0].joints.size() == 1);
  CHECK(m.bodies[0].joints[0].type == "free");
  REQUIRE(m.bodies[1].joints.size() == 1);
  const model::Joint& turn = m.bodies[1].joints[0];
  CHECK(turn.name == "turn");
  CHECK(turn.type == "hinge");
  CHECK(turn.range == Eigen::Vector2d(-1, 1));
  CHECK(turn.axis == Eigen::Vector3d(0, 1, 0));
}

TEST_CASE("mass and bounds are of the whole model in the world") {
  const TemporaryFolder folder;
  const Result result = LoadText(folder, kArm);
  REQUIRE(result.model);
  const model::Object& m = result.model->object;
  CHECK(m.mass_properties.mass == Approx(3));
  CHECK(m.mass_properties.p_FCm.isApprox(Eigen::Vector3d(1.0 / 3, 0, 1), 1e-12));
  // About the common centre: 2 kg at 1/3 m and 1 kg at 2/3 m along x, and a box
  // of half height 0.3 and half depth 0.1 (m/3 (a^2 + c^2)) and the capsule.
  const double capsule = 0.01 * 0.8 * std::numbers::pi;    // volume, m^3
  const double caps = 4.0 / 3 * std::numbers::pi * 0.001;  // m^3
  const double straight = capsule / (capsule + caps);      // share of the mass
  const double across =
      straight * (0.01 / 4 + 0.16 / 3) + (1 - straight) * (2 * 0.01 / 5 + 0.16 + 0.75 * 0.4 * 0.1);
  CHECK(m.mass_properties.I_Cm_F(1, 1) ==
        Approx(2 * (1.0 / 9) + 4.0 / 9 + 2.0 / 3 * (0.01 + 0.09) + across));
  CHECK(m.bounds.aabb.min.isApprox(Eigen::Vector3d(-0.1, -0.2, 0.5), 1e-12));
  CHECK(m.bounds.aabb.max.isApprox(Eigen::Vector3d(1.1, 0.2, 1.5), 1e-12));
}

TEST_CASE("bodies have their pose, mass and tensor in their own frame, elements their names") {
  const TemporaryFolder folder;
  const Result result = LoadText(folder, R"(<mujoco>
  <worldbody>
    <camera name="eye"/>
    <body name="a" pos="1 2 3" quat="0 1 0 0">
      <joint name="turn"/>
      <inertial pos="0.1 0.2 0.3" quat="0.7071067811865476 0 0 0.7071067811865476" mass="2"
                diaginertia="3 4 5"/>
    </body>
    <body name="b"><joint/><geom name="ball" size="1"/></body>
  </worldbody>
  <contact><exclude name="apart" body1="a" body2="b"/></contact>
  <equality><weld body1="a"/></equality>
  <tendon><fixed name="sum"><joint joint="turn" coef="1"/></fixed></tendon>
  <actuator><motor name="drive" joint="turn"/></actuator>
  <sensor><jointpos name="angle" joint="turn"/></sensor>
</mujoco>)");
  REQUIRE(result.model);
  const model::Body& a = result.model->object.bodies[0];
  CHECK(a.X_PB.p == Eigen::Vector3d(1, 2, 3));
  CHECK(a.X_PB.q.coeffs() == Eigen::Vector4d(1, 0, 0, 0));  // x y z w
  CHECK(a.mass_properties.mass == 2);
  CHECK(a.mass_properties.p_FCm.isApprox(Eigen::Vector3d(0.1, 0.2, 0.3), 1e-15));
  CHECK(a.mass_properties.I_Cm_F.isApprox(Eigen::Matrix3d(Eigen::Vector3d(4, 3, 5).asDiagonal()),
                                          1e-12));
  std::vector<std::string> elements;
  for (const auto& [kind, name] : result.model->elements) elements.push_back(kind + " " + name);
  CHECK(elements == std::vector<std::string>{"camera eye", "exclude apart", "equality ",
                                             "tendon sum", "actuator drive", "sensor angle"});
}

TEST_CASE("files beside the model are found") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "assets");
  std::ofstream(folder.path() / "assets" / "t.obj")
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  std::ofstream(folder.path() / "more.xml")
      << "<mujoco><worldbody><body name=\"b\"><geom type=\"mesh\" mesh=\"t\"/></body></worldbody>"
         "</mujoco>";
  const Result result = LoadText(folder,
                                 "<mujoco><asset><mesh name=\"t\" file=\"assets/t.obj\"/></asset>"
                                 "<include file=\"more.xml\"/></mujoco>");
  REQUIRE(result.model);
  CHECK(result.model->object.bounds.aabb.max.isApprox(Eigen::Vector3d(1, 1, 1), 1e-6));
  CHECK(result.model->object.bounds.aabb.min.norm() < 1e-6);
}

TEST_CASE("a file that is not there or is a folder cannot be read") {
  const TemporaryFolder folder;
  const std::string path = folder.path().string();
  CHECK(Only(LoadFile(folder.path() / "no.xml")) ==
        "0:0: yaml/cannot-read: cannot read '" + path + "/no.xml': No such file or directory");
  CHECK(Only(LoadFile(folder.path())) ==
        "0:0: yaml/cannot-read: cannot read '" + path + "': it is a folder");
}

TEST_CASE("what is not XML is reported where it stops being XML") {
  const TemporaryFolder folder;
  CHECK(Only(LoadText(folder, "<mujoco>\n  <a>\n  </b>\n</mujoco>\n")) ==
        "3:5: mujoco/not-mjcf: not an XML file: start-end tags mismatch");
  CHECK(Only(LoadText(folder, "")) ==
        "1:1: mujoco/not-mjcf: not an XML file: no document element found");
  CHECK(Only(LoadText(folder, "name: hammer\n")) ==
        "1:1: mujoco/not-mjcf: not an XML file: no document element found");
}

TEST_CASE("another root element is reported, a URDF with what to do") {
  const TemporaryFolder folder;
  CHECK(Only(LoadText(folder, "<?xml version=\"1.0\"?>\n<html/>\n")) ==
        "2:2: mujoco/not-mjcf: the root element is <html>, not <mujoco>");
  const Result urdf = LoadText(folder, "<robot name=\"r\"/>\n");
  CHECK(Only(urdf) ==
        "1:2: mujoco/not-mjcf: the root element is <robot>, not <mujoco>: this is a URDF file");
  CHECK(urdf.findings[0].hint ==
        "convert it to MJCF first: load it in MuJoCo and save it with mj_saveLastXML");
}

TEST_CASE("MuJoCo's refusal points at the line of the file") {
  const TemporaryFolder folder;
  const Result result = LoadText(
      folder,
      "<mujoco>\n  <worldbody>\n    <geom name=\"g\" sze=\"1\"/>\n  </worldbody>\n</mujoco>");
  CHECK(Only(result) ==
        "3:5: mujoco/error: MuJoCo refused geom 'g': Schema violation: unrecognized attribute: "
        "'sze'");
  CHECK_FALSE(result.model);
}

TEST_CASE("a line may be one of an included file") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "bad.xml")
      << "<mujoco>\n<worldbody>\n<geom/>\n</worldbody></mujoco>";
  for (const std::string name : {"include", "Include"}) {
    const Result result =
        LoadText(folder, "<mujoco>\n  <" + name + " file=\"bad.xml\"/>\n\n</mujoco>\n");
    REQUIRE(result.findings.size() == 1);
    CHECK(result.findings[0].hint == "the line may be in an included file");
  }
}

TEST_CASE("numbers that are not finite are found in a file that MuJoCo takes") {
  const TemporaryFolder folder;
  const Result result = LoadText(
      folder,
      "<mujoco><worldbody><body name=\"b\"><geom name=\"g\" size=\"1\" friction=\"nan\"/></body>"
      "</worldbody></mujoco>");
  REQUIRE(result.findings.size() == 2);
  CHECK(result.findings[0].message ==
        "MuJoCo warns: XML contains a 'NaN'. Please check it carefully");
  CHECK(result.findings[1].message ==
        "MuJoCo loaded a friction of geom 'g' that is not a finite number");
  CHECK(result.findings.HasErrors());
}

/// Messages of the findings, which must be warnings.
std::vector<std::string> Warnings(const Result& result) {
  CHECK(result.model);
  CHECK_FALSE(result.findings.HasErrors());
  std::vector<std::string> warnings;
  for (const diag::Finding& finding : result.findings) {
    CHECK(finding.code == diag::Code::kMujocoOlder);
    warnings.push_back(finding.message);
  }
  return warnings;
}

#if mjVERSION_HEADER < 230
constexpr bool kIsOld = true;
#else
constexpr bool kIsOld = false;
#endif

TEST_CASE("a mass of meshes is that of later releases, with a warning if 2.2 has another") {
  const TemporaryFolder folder;
  const auto load = [&](const std::string& faces) {
    return LoadText(folder,
                    "<mujoco><asset><mesh name=\"m\" vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\" "
                    "face=\"" +
                        faces +
                        "\"/></asset><worldbody><body><freejoint/>"
                        "<geom type=\"mesh\" mesh=\"m\"/></body></worldbody></mujoco>");
  };
  const Result corner = load("0 2 1 0 1 3 0 3 2 1 2 3");
  REQUIRE(corner.model);
  CHECK(corner.model->object.mass_properties.mass == Approx(1000.0 / 6));
  CHECK(Warnings(corner).size() == (kIsOld ? 1 : 0));
  const Result turned = load("0 1 2 0 1 3 0 3 2 1 2 3");
  REQUIRE(turned.model);
  CHECK(turned.model->object.mass_properties.mass == Approx(1000.0 / 6));
  if (kIsOld)
    CHECK(Warnings(turned).at(0).starts_with("MuJoCo 2.2.2 rejects the model: faces have"));
}

TEST_CASE("a limit of memory in MuJoCo 2.2 is a warning") {
  const TemporaryFolder folder;
  std::string text = "<mujoco><worldbody><geom type=\"plane\" size=\"9 9 1\"/>";
  for (int i = 0; i < 40; ++i) {
    text += "<body pos=\"" + std::to_string(i) +
            " 0 0.0999\"><freejoint/><geom type=\"box\" size=\"0.1 0.1 0.1\"/></body>";
  }
  const Result boxes = LoadText(folder, text + "</worldbody></mujoco>");
  const std::vector<std::string> expected = {
      "MuJoCo 2.2.2 ignores contacts that exceed its buffer"};
  CHECK(Warnings(boxes) == (kIsOld ? expected : std::vector<std::string>{}));
}

TEST_CASE("a model that later releases reject is read with a warning") {
  const TemporaryFolder folder;
  const std::string square = "vertex=\"0 0 0 1 0 0 1 1 0 0 1 0\" face=\"0 1 2 0 2 3\"";
  const std::string seen =
      "<worldbody><geom type=\"mesh\" mesh=\"m\" contype=\"0\" conaffinity=\"0\"/></worldbody>";
  struct Case {
    std::string inner;
    int refused_since;
    std::string warning;
  };
  const Case cases[] = {
      {"<asset><mesh name=\"m\" " + square + "/></asset>" + seen, 330,
       "1:1: mujoco/later-refuses: mesh 'm' has a volume of 0 m^3; MuJoCo 3.3.0 and later reject a "
       "mesh of less than 1e-15 m^3, even if it is only seen"},
      {"<worldbody><camera name=\"c\" fovy=\"180\"/></worldbody>", 300,
       "1:1: mujoco/later-refuses: camera 'c' has a 'fovy' of 180 degrees; MuJoCo 3.0.0 and later "
       "require less than 180"},
      {"<worldbody><body><joint name=\"j\" type=\"ball\"/><geom size=\"1\"/></body></worldbody>"
       "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/></fixed></tendon>",
       4000000,
       "1:1: mujoco/later-refuses: tendon 't' has a ball or free joint; MuJoCo 4.0.0 and later "
       "require hinges and slides"},
      {"<worldbody><body><joint name=\"j\"/><geom size=\"1\"/></body></worldbody>"
       "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"j\" "
       "coef=\"2\"/></fixed></tendon>",
       4000000,
       "1:1: mujoco/later-refuses: tendon 't' has joint 'j' twice, which MuJoCo 4.0.0 and later "
       "reject"},
      {"<option><flag passive=\"disable\"/></option>", 336,
       "2:15: mujoco/later-refuses: the flag on line 2 has 'passive', which MuJoCo 3.3.6 and later "
       "reject"}};
  for (const auto& [inner, refused_since, warning] : cases) {
    const Result result = LoadText(folder, "<mujoco>\n" + inner + "</mujoco>");
    CHECK(result.model.has_value() == (mjVERSION_HEADER < refused_since));
    if (mjVERSION_HEADER < 230) CHECK(Only(result) == warning);
  }
  // A tilted square has a volume by rounding, and a mesh of 20 um is large enough.
  const std::string tilted = "vertex=\"0 0 0 .1 .03 .07 .3 .2 .1 .2 .17 .03\" face=\"0 1 2 0 2 3\"";
  const std::string tiny =
      "vertex=\"0 0 0 2e-5 0 0 0 2e-5 0 0 0 2e-5\" face=\"0 2 1 0 1 3 0 3 2 1 2 3\"";
  for (const std::string& mesh : {tilted, tiny}) {
    CHECK(LoadText(folder,
                   "<mujoco><asset><mesh name=\"m\" " + mesh + "/></asset>" + seen + "</mujoco>")
              .findings.empty());
  }
}

}  // namespace
}  // namespace mjforge::validate
