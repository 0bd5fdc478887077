#include "mjforge/backport/backport.h"

#include <array>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "backported.h"
#include "mjforge/backport/mjcf_versions.h"

namespace mjforge::backport {
namespace {

/// An arm with these attributes of its joint, this servo and these default classes.
std::string Arm(const std::string& joint, const std::string& servo,
                const std::string& defaults = "") {
  return "<compiler angle=\"radian\" autolimits=\"true\"/>\n<default>" + defaults +
         "</default>\n<worldbody><body><joint name=\"j\" " + joint +
         "/><geom size=\"1\"/></body></worldbody>\n<actuator>" + servo + "</actuator>";
}

TEST_CASE("a range limits where the file does not say") {
  const Backported file(
      "<worldbody><body><joint range=\"0 90\"/><geom size=\"1\"/></body></worldbody>");
  CHECK(file.changed);
  CHECK(file.findings.empty());
  CHECK(file.Says("<compiler autolimits=\"true\">"));
  engine::Loaded loaded;
  CHECK(Load(file.text, loaded)->jnt_limited[0] == 1);
}

TEST_CASE("a compiler section that is there says so, and its own word is kept") {
  const std::string joint =
      "\n<worldbody><body><joint range=\"0 1\"/><geom size=\"1\"/></body></worldbody>";
  CHECK(Backported("<compiler angle=\"radian\"/>" + joint)
            .Says("<compiler angle=\"radian\" autolimits=\"true\">"));
  CHECK_FALSE(Backported("<compiler autolimits=\"false\"/>" + joint).changed);
}

TEST_CASE("actuators with a state come last") {
  const Backported file(Arm("",
                            "<general name=\"a\" joint=\"j\" class=\"slow\"/><motor name=\"b\" "
                            "joint=\"j\"/><muscle name=\"c\" joint=\"j\" lengthrange=\"0 1\"/>"
                            "<motor name=\"d\" joint=\"j\"/>",
                            "<default class=\"slow\"><general dyntype=\"filter\"/></default>"));
  CHECK(file.changed);
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  std::string names;
  for (int i = 0; i < m.nu; ++i) names += mj_id2name(&m, mjOBJ_ACTUATOR, i);
  CHECK(names == "bdac");
}

TEST_CASE("a range of controls that a class says stands in the element, where it must") {
  const Backported file(Arm("", "<damper joint=\"j\" kv=\"1\"/>", "<damper ctrlrange=\"0 2\"/>"));
  engine::Loaded loaded;
  CHECK(Load(file.text, loaded)->actuator_ctrlrange[1] == 2);
}

TEST_CASE("what MuJoCo 2.2 reads as it stands is left alone") {
  CHECK_FALSE(Backported("<worldbody><body><joint limited=\"true\" range=\"0 1\"/><geom "
                         "size=\"1\"/></body></worldbody><option integrator=\"RK4\"/>")
                  .changed);
  CHECK_FALSE(Backported("<actuator><velocity joint=\"j\" kv=\"2\"/></actuator>").changed);
  // MuJoCo rejects a typing error.
  CHECK_FALSE(Backported("<visual><global fovi=\"3\"/></visual>").changed);
}

TEST_CASE("what is only seen or only computes is left out, with one warning for each name") {
  const Backported file(
      "<visual>\n  <global fovy=\"40\"\n    ellipsoidinertia=\"true\"/>\n</visual>\n"
      "<option integrator=\"implicitfast\" ls_iterations=\"9\"/>\n"
      "<asset>\n<material name=\"a\" metallic=\"1\"/>\n<material name=\"b\" metallic=\"0.5\"/>\n"
      "</asset>\n<sensor>\n<e_kinetic/></sensor>");
  CHECK(file.findings ==
        Strings{"4:5 warning: 'ellipsoidinertia' of the global on line 3 is left out: it changes "
                "only what is seen (MuJoCo 2.3.4)",
                "6:9 warning: 'integrator=implicitfast' of the option on line 6 is left out: it "
                "changes only "
                "how the whole model is simulated (MuJoCo 2.3.3)",
                "6:35 warning: 'ls_iterations' of the option on line 6 is left out: it changes "
                "only how the same is computed (MuJoCo 3.0.0)",
                "8:20 warning: 'metallic' of material 'a' is left out: it changes only what is "
                "seen (MuJoCo 3.1.5)",
                "12:1 warning: the e_kinetic on line 12 is left out: it only reads, and acts on "
                "nothing (MuJoCo 3.3.0)"});
  engine::Loaded loaded;
  Load(file.text, loaded);
}

/// Two hinged balls, and these sections.
std::string Pair(const std::string& sections) {
  return "<worldbody><body name=\"b\"><joint name=\"j\"/><geom name=\"g\" size=\"1\"/></body>"
         "<body><joint name=\"k\"/><geom size=\"1\"/></body></worldbody>\n" +
         sections;
}

TEST_CASE("a list of numbers has the length that MuJoCo 2.2 requires") {
  const Backported file(Pair(
      "<equality><joint joint1=\"j\" joint2=\"k\" polycoef=\"0 -1\"/></equality>\n"
      "<tendon><fixed name=\"t\" springlength=\"0.5 0.5\" stiffness=\"2 0\"><joint joint=\"j\" "
      "coef=\"1\"/></fixed></tendon><default><joint damping=\"3 0 0\"/></default>"));
  CHECK(file.findings.empty());
  CHECK(file.Says("polycoef=\"0 -1 0 0 0\""));
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.eq_data[1] == -1);
  CHECK(m.tendon_stiffness[0] == 2);
  CHECK(m.dof_damping[0] == 3);
  CHECK(Backported(Pair("<equality><joint joint1=\"j\" polycoef=\"0.5\"/></equality>"))
            .Says("polycoef=\"0.5 1 0 0 0\""));
  CHECK_FALSE(Backported(Pair("<equality><joint joint1=\"j\" polycoef=\"0 -1\"/></equality>"), 316)
                  .changed);
}

TEST_CASE("a list of numbers that MuJoCo 2.2 cannot hold is an error") {
  const Backported file(Pair(
      "<tendon><fixed springlength=\"0 1\" damping=\"1 2\"><joint joint=\"j\" coef=\"1\"/></fixed>"
      "</tendon>"));
  CHECK(file.findings ==
        Strings{"3:16 error: 'springlength' of the fixed on line 3 with 2 numbers needs MuJoCo "
                "2.3.1",
                "3:35 error: 'damping' of the fixed on line 3 with 2 numbers needs MuJoCo 3.7.0"});
}

TEST_CASE(
    "a list of numbers that is too long for each release is left to MuJoCo, which rejects it") {
  const std::string too_long[] = {
      "<equality><joint joint1=\"j\" joint2=\"k\" polycoef=\"0 1 0 0 0 0\"/></equality>",
      "<tendon><fixed springlength=\".1 .1 .1\"><joint joint=\"j\" coef=\"1\"/></fixed></tendon>",
      "<tendon><fixed damping=\"1 0 0 0\"><joint joint=\"j\" coef=\"1\"/></fixed></tendon>",
      "<default><joint stiffness=\"1 0 0 0\"/></default>"};
  for (const std::string& sections : too_long) {
    const Backported file(Pair(sections));
    CHECK_FALSE(file.changed);
    CHECK(engine::Engine().LoadText(file.text).error.find("has too much data") !=
          std::string::npos);
  }
}

TEST_CASE("settings of the model are no warning where only its bodies are used") {
  const Backported file(
      "<option integrator=\"implicitfast\"/><visual><global ellipsoidinertia=\"true\"/></visual>",
      kPortable, Use::kBodies);
  CHECK(file.findings.empty());
  CHECK_FALSE(file.Says("implicitfast"));
  CHECK_FALSE(file.Says("ellipsoidinertia"));
}

TEST_CASE("what would mean something else is an error that names the release") {
  const Backported file(
      "<worldbody>\n<attach model=\"m\" prefix=\"p\"/>\n<frame>\n"
      "<body name=\"b\" gravcomp=\"0.5\"/></frame>\n<geom type=\"sdf\"/></worldbody>\n"
      "<actuator><position joint=\"j\" dampratio=\"1\"/></actuator>");
  CHECK(file.findings ==
        Strings{"3:1 error: the attach on line 3 needs MuJoCo 3.2.0",
                "4:1 error: the frame on line 4 needs MuJoCo 3.1.2",
                "5:16 error: 'gravcomp' of body 'b' needs MuJoCo 2.3.1",
                "6:7 error: 'type=sdf' of the geom on line 6 needs MuJoCo 3.0.0",
                "7:31 error: 'dampratio' of the position on line 7 needs MuJoCo 3.1.6"});
}

TEST_CASE("frames and replicates are left to a release that expands them") {
  const std::string inner =
      "<worldbody><frame>\n<replicate count=\"2\"><geom "
      "size=\"1\"/></replicate></frame></worldbody>";
  CHECK_FALSE(Backported(inner, 315).changed);
  CHECK(Backported(inner, 314).findings ==
        Strings{"3:1 error: the replicate on line 3 needs MuJoCo 3.1.5"});
  const bool expands = mjVERSION_HEADER >= 315;
  CHECK(Backported(inner, kPortable, Use::kBodies).findings.empty() == expands);
}

TEST_CASE("a usual value, and a class that nothing has, change nothing") {
  const Backported file(
      "<default>\n<default class=\"no\"><joint actuatorgravcomp=\"true\"/></default></default>\n"
      "<worldbody>\n<body gravcomp=\"0\"><joint/><geom size=\"1\"/></body></worldbody>");
  CHECK(file.findings ==
        Strings{"3:28 warning: 'actuatorgravcomp' of the joint on line 3 is left out: nothing in "
                "the file has it from there (MuJoCo 3.1.4)",
                "5:7 warning: 'gravcomp' of the body on line 5 is left out: with this value it "
                "changes nothing (MuJoCo 2.3.1)"});
}

TEST_CASE("what an element has from its class, or the class of a body above, counts") {
  const std::string defaults =
      "<default>\n<default class=\"up\"><joint actuatorgravcomp=\"true\"/>"
      "<default class=\"in\"/></default></default>\n";
  const Strings error = {
      "3:28 error: 'actuatorgravcomp' of the joint on line 3 needs MuJoCo 3.1.4"};
  CHECK(Backported(defaults + "<worldbody><body childclass=\"in\"><body><joint/></body></body>"
                              "</worldbody>")
            .findings == error);
  CHECK(
      Backported(defaults + "<worldbody><body><joint class=\"up\"/></body></worldbody>").findings ==
      error);
  CHECK(Backported("<default><joint actuatorgravcomp=\"true\"/></default>\n"
                   "<worldbody><body><freejoint/></body></worldbody>")
            .findings.front()
            .starts_with("2:17 warning"));
}

TEST_CASE("what a release knows, it reads") {
  const std::string inner = "<worldbody><body gravcomp=\"1\"/></worldbody>";
  CHECK(Backported(inner, 230).findings.size() == 1);
  CHECK_FALSE(Backported(inner, 231).changed);
  CHECK_FALSE(Backported("<option><flag speculative=\"enable\"/></option>", 4000000).changed);
}

TEST_CASE("a servo's damping is the third number of its bias") {
  const Backported file(Arm("", "<position joint=\"j\" kp=\"300\" kv=\"40\"/>"));
  CHECK(file.findings.empty());
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.actuator_gainprm[0] == 300);
  CHECK(m.actuator_biastype[0] == mjBIAS_AFFINE);
  CHECK(m.actuator_biasprm[1] == -300);
  CHECK(m.actuator_biasprm[2] == -40);
}

TEST_CASE("gains come from classes, too") {
  const Backported file(
      Arm("", "<position joint=\"j\" class=\"in\"/>",
          "<position kp=\"7\" kv=\"3\"/><default class=\"in\"><position kp=\"5\"/>"
          "</default>"));
  CHECK(file.findings.empty());
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.actuator_gainprm[0] == 5);
  CHECK(m.actuator_biasprm[2] == -3);
}

TEST_CASE("gains among those of other actuators are an error, unless the servo says its own") {
  const std::string defaults = "<damper kv=\"2\" ctrlrange=\"0 1\"/>";
  CHECK(Backported(Arm("", "<position joint=\"j\" kv=\"40\"/>", defaults)).findings ==
        Strings{"5:31 error: 'kv' of the position on line 5 needs MuJoCo 3.1.0"});
  CHECK(
      Backported(Arm("", "<position joint=\"j\" kp=\"1\" kv=\"40\"/>", defaults)).findings.empty());
  CHECK(Backported(Arm("", "<general joint=\"j\" biastype=\"affine\"/>", "<position kv=\"40\"/>"))
            .findings == Strings{"3:20 error: 'kv' of the position on line 3 needs MuJoCo 3.1.0"});
}

TEST_CASE("a velocity servo with a position keeps its damping") {
  const Backported file(Arm("", "<intvelocity joint=\"j\" kp=\"9\" kv=\"2\" actrange=\"-1 1\"/>"));
  CHECK(file.findings.empty());
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.actuator_dyntype[0] == mjDYN_INTEGRATOR);
  CHECK(m.actuator_biasprm[2] == -2);
  CHECK(m.actuator_actlimited[0] == 1);
}

TEST_CASE("an inherited range is the joint's, about its middle") {
  const Backported file(
      "<compiler autolimits=\"true\"/>\n<worldbody><body><joint name=\"j\" range=\"-90 180\"/>"
      "<geom size=\"1\"/></body></worldbody>\n"
      "<actuator><position joint=\"j\" inheritrange=\"0.5\"/></actuator>");
  CHECK(file.findings.empty());
  engine::Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.actuator_ctrllimited[0] == 1);
  CHECK(m.actuator_ctrlrange[0] == Approx(mjPI / 180 * -22.5));
  CHECK(m.actuator_ctrlrange[1] == Approx(mjPI / 180 * 112.5));
}

TEST_CASE("a motor has no use for a range that a servo in its class would inherit") {
  CHECK(Backported(Arm("", "<motor joint=\"j\"/>", "<position inheritrange=\"1\"/>")).findings ==
        Strings{"3:20 warning: 'inheritrange' of the position on line 3 is left out: only servos "
                "inherit ranges (MuJoCo 3.1.3)"});
}

TEST_CASE("a joint's limit of forces is that of its only actuator") {
  const auto range = [](const std::string& actuator) {
    const Backported file(Arm("actuatorfrcrange=\"-10 20\"", actuator));
    CHECK(file.findings.empty());
    engine::Loaded loaded;
    const mjModel& m = *Load(file.text, loaded);
    CHECK(m.actuator_forcelimited[0] == 1);
    return std::pair(m.actuator_forcerange[0], m.actuator_forcerange[1]);
  };
  CHECK(range("<motor joint=\"j\"/>") == std::pair(-10.0, 20.0));
  CHECK(range("<motor joint=\"j\" gear=\"-5\"/>") == std::pair(-4.0, 2.0));
  CHECK(range("<motor joint=\"j\" forcerange=\"-15 15\" forcelimited=\"true\"/>") ==
        std::pair(-10.0, 15.0));
  CHECK(range("<motor joint=\"j\" forcerange=\"-1 1\" forcelimited=\"false\"/>") ==
        std::pair(-10.0, 20.0));
}

TEST_CASE("a limit on nothing is left out, one on several actuators is an error") {
  CHECK(Backported(Arm("actuatorfrcrange=\"-10 20\"", "")).findings ==
        Strings{"4:34 warning: 'actuatorfrcrange' of joint 'j' is left out: no actuator of the "
                "file moves the joint (MuJoCo 3.0.0)"});
  const Strings error = {"4:34 error: 'actuatorfrcrange' of joint 'j' needs MuJoCo 3.0.0"};
  CHECK(Backported(Arm("actuatorfrcrange=\"-10 20\"", "<motor joint=\"j\"/><motor joint=\"j\"/>"))
            .findings == error);
  CHECK(Backported(Arm("actuatorfrcrange=\"-10 20\"", "<motor joint=\"j\"/>\n<motor site=\"s\"/>"))
            .findings == error);
  CHECK(Backported(Arm("actuatorfrcrange=\"-10 20\"",
                       "<motor tendon=\"t\"/></actuator>"
                       "<tendon><fixed name=\"t\"><joint joint=\"j\" "
                       "coef=\"1\"/></fixed></tendon><actuator>"))
            .findings == error);
}

TEST_CASE("how a mesh is weighed matters where a mass comes from it") {
  const std::string asset = "<asset><mesh name=\"m\" file=\"m.stl\" inertia=\"shell\"/></asset>\n";
  const auto body = [&](const std::string& inner) {
    return Backported(asset + "<worldbody><body>" + inner + "</body></worldbody>").findings;
  };
  const std::string geom = "<geom type=\"mesh\" mesh=\"m\"/>";
  CHECK(body(geom).empty());  // AddMeshInertia() applies it
  const Strings none = {
      "2:36 warning: 'inertia=shell' of mesh 'm' is left out: no mass is computed from the mesh "
      "(MuJoCo "
      "3.3.0)"};
  CHECK(body("<inertial mass=\"1\" pos=\"0 0 0\" diaginertia=\"1 1 1\"/>" + geom) == none);
  CHECK(body("<geom type=\"mesh\" mesh=\"m\" mass=\"0\"/>") == none);
  CHECK(body("<geom type=\"box\" mesh=\"m\" mass=\"0\"/>").front().starts_with("2:36 error"));
}

TEST_CASE("folders, lights, cameras and layers are said in older words") {
  const Backported file(
      "<compiler assetdir=\"a\" texturedir=\"t\"/>"
      "<asset><material name=\"m\"><layer role=\"rgb\" texture=\"x\"/></material></asset>"
      "<worldbody><light type=\"directional\"/>"
      "<camera sensorsize=\"0.02 0.01\" focal=\"0.01 0.005\"/></worldbody>");
  CHECK(file.findings.empty());
  CHECK(file.Says("<compiler texturedir=\"t\" meshdir=\"a\">"));
  CHECK(file.Says("<material name=\"m\" texture=\"x\"></material>"));
  CHECK(file.Says("<light directional=\"true\">"));
  CHECK(file.Says("<camera fovy=\"90\">"));
}

TEST_CASE("skins are left out with their section, flexes are an error") {
  CHECK(Backported("<deformable>\n<skin name=\"s\"/></deformable>").findings ==
        Strings{"2:1 warning: the deformable on line 2 is left out: it changes only what is seen "
                "(MuJoCo 3.0.0)"});
  CHECK(Backported("<deformable>\n<flex name=\"s\"/></deformable>").findings.back() ==
        "3:1 error: flex 's' needs MuJoCo 3.0.0");
}

TEST_CASE("elements stay on their lines") {
  const Backported file("<!-- one\ntwo -->\n<worldbody>\n\n<body gravcomp=\"0\"/></worldbody>");
  CHECK(file.text == "<mujoco>\n\n\n<worldbody>\n\n<body></body></worldbody></mujoco>");
}

TEST_CASE("the table agrees with the schema of the MuJoCo that runs") {
  std::vector<char> schema(200'000);
  REQUIRE(mj_printSchema(nullptr, schema.data(), static_cast<int>(schema.size()), 0, 0) > 0);
  std::istringstream words(schema.data());
  std::set<std::string> known;
  for (std::string word; words >> word;) known.insert(word);
  // Each is a word that no other part of MJCF has.
  for (const auto& [parent, tag, attribute] :
       std::vector<std::array<std::string, 3>>{{"compiler", "lengthrange", "interval"},
                                               {"mujoco", "option", "ls_iterations"},
                                               {"option", "flag", "nativeccd"},
                                               {"visual", "global", "ellipsoidinertia"},
                                               {"asset", "mesh", "maxhullvert"},
                                               {"asset", "material", "roughness"},
                                               {"worldbody", "body", "gravcomp"},
                                               {"body", "joint", "actuatorfrcrange"},
                                               {"body", "joint", "actuatorgravcomp"},
                                               {"body", "geom", "surfacevel"},
                                               {"body", "camera", "sensorsize"},
                                               {"body", "light", "bulbradius"},
                                               {"tendon", "fixed", "springyield"},
                                               {"actuator", "general", "actearly"},
                                               {"actuator", "position", "dampratio"},
                                               {"actuator", "position", "inheritrange"},
                                               {"actuator", "muscle", "tausmooth"}}) {
    INFO(attribute);
    const MjcfFeature* later = FindFeature(parent, tag, attribute, "1");
    REQUIRE(later != nullptr);
    CHECK(known.contains(attribute) == (later->since <= mjVERSION_HEADER));
  }
}

TEST_CASE("releases are named as their authors do") {
  CHECK(VersionText(230) == "2.3.0");
  CHECK(VersionText(316) == "3.1.6");
  CHECK(VersionText(3012000) == "3.12.0");
}

}  // namespace
}  // namespace mjforge::backport
