#include "mjforge/engine/frames.h"

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "adapted.h"
#include "mjforge/engine/placed_elements.h"

namespace mjforge::engine {
namespace {

using Numbers = std::vector<double>;

/// What MuJoCo 2.2 makes of a file with these sections and with this in its world.
struct Composed {
  explicit Composed(const std::string& world, const std::string& sections = "")
      : file(sections + "<worldbody>" + world + "</worldbody>") {
    CHECK(file.findings.empty());
    CHECK_FALSE(file.Says("frame"));
    Load(file.text, loaded);
  }
  const mjModel& model() const { return *loaded.model; }

  Adapted file;
  Loaded loaded;
};

void CheckNear(const mjtNum* seen, const Numbers& meant) {
  INFO(TextOf({seen, seen + meant.size()}));
  for (std::size_t i = 0; i < meant.size(); ++i) CHECK(seen[i] == Approx(meant[i]).margin(1e-12));
}

const std::string kBall = "<geom name=\"g\" size=\"1\"/>";

TEST_CASE("a frame moves and turns what stands in it") {
  const Composed file(
      "<body><frame pos=\"1 0 0\" euler=\"0 0 90\">"
      "<joint name=\"j\" pos=\"0.5 0 0\" axis=\"1 0 0\"/><geom size=\"1\" pos=\"2 0 0\"/>"
      "<site pos=\"0 1 0\"/><camera pos=\"0 0 3\"/>"
      "<light pos=\"1 1 0\" dir=\"1 0 0\"/><body pos=\"0 4 0\"><geom size=\"1\"/></body>"
      "</frame></body>");
  const mjModel& m = file.model();
  const double half = std::sqrt(0.5);
  CheckNear(m.jnt_pos, {1, 0.5, 0});
  CheckNear(m.jnt_axis, {0, 1, 0});
  CheckNear(m.geom_pos, {1, 2, 0});
  CheckNear(m.geom_quat, {half, 0, 0, half});
  CheckNear(m.site_pos, {0, 0, 0});
  CheckNear(m.cam_pos, {1, 0, 3});
  CheckNear(m.cam_quat, {half, 0, 0, half});
  CheckNear(m.light_pos, {0, 1, 0});
  CheckNear(m.light_dir, {0, 1, 0});
  CheckNear(m.body_pos + 6, {-3, 0, 0});
  CheckNear(m.body_quat + 8, {half, 0, 0, half});
}

TEST_CASE("frames within frames are multiplied, and each word for an orientation is read") {
  const double half = std::sqrt(0.5);
  for (const std::string quarter : {"quat=\"3 0 0 3\"", "axisangle=\"0 0 2 90\"",
                                    "euler=\"0 0 90\"", "xyaxes=\"0 1 0 -1 1 0\""}) {
    INFO(quarter);
    const Composed file("<frame name=\"a\" " + quarter + "><frame pos=\"1 0 0\" " + quarter + ">" +
                        kBall + "</frame></frame>");
    CheckNear(file.model().geom_pos, {0, 1, 0});
    CheckNear(file.model().geom_quat, {0, 0, 0, 1});
  }
  CheckNear(Composed("<frame zaxis=\"1 0 0\">" + kBall + "</frame>").model().geom_quat,
            {half, 0, half, 0});
}

TEST_CASE("angles are those of the compiler, capital letters axes that stay") {
  const auto quat = [](const std::string& compiler) {
    const Composed file("<frame euler=\"90 90 0\"><geom size=\"1\"/></frame>",
                        "<compiler " + compiler + "/>");
    return Numbers(file.model().geom_quat, file.model().geom_quat + 4);
  };
  CheckNear(quat("eulerseq=\"xyz\"").data(), {0.5, 0.5, 0.5, 0.5});
  CheckNear(quat("eulerseq=\"XYZ\"").data(), {0.5, 0.5, 0.5, -0.5});
  CheckNear(quat("eulerseq=\"zxy\"").data(), {0.5, 0.5, 0.5, 0.5});
  const Composed radian("<frame euler=\"0 0 1.5707963267948966\">" + kBall + "</frame>",
                        "<compiler angle=\"radian\"/>");
  CheckNear(radian.model().geom_quat, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
}

TEST_CASE("the ends of a geom or a site are a pose and a size") {
  const Composed file(
      "<frame pos=\"0 0 1\" euler=\"90 0 0\">"
      "<geom type=\"capsule\" size=\"0.1\" fromto=\"0 0 0 0 0 2\"/>"
      "<geom type=\"box\" size=\"0.1 9 9\" fromto=\"1 0 0 3 0 0\"/>"
      "<site type=\"cylinder\" size=\"0.2\" fromto=\"0 2 0 0 0 0\"/></frame>");
  const mjModel& m = file.model();
  CheckNear(m.geom_pos, {0, -1, 1});
  CheckNear(m.geom_size, {0.1, 1});
  CheckNear(m.geom_pos + 3, {2, 0, 1});
  CheckNear(m.geom_size + 3, {0.1, 0.1, 1});
  CheckNear(m.site_pos, {0, 0, 2});
  CheckNear(m.site_size, {0.2, 1});
  // The axis of the capsule, from its second end to the first.
  mjtNum axis[3];
  const mjtNum z[] = {0, 0, 1};
  mju_rotVecQuat(axis, z, m.geom_quat);
  CheckNear(axis, {0, 1, 0});
}

TEST_CASE("what a class says of a pose is moved, too") {
  const Composed file(
      "<frame pos=\"0 0 1\"><geom/><geom class=\"in\"/><geom class=\"in\" axisangle=\"0 0 1 0\"/>"
      "</frame><geom class=\"in\"/>",
      "<default><geom size=\"1 1 1\" type=\"box\" pos=\"1 0 0\" zaxis=\"0 0 -1\"/>"
      "<default class=\"in\"><geom euler=\"0 0 90\"/></default></default>");
  const mjModel& m = file.model();
  const double half = std::sqrt(0.5);
  CheckNear(m.geom_pos, {1, 0, 1});
  CheckNear(m.geom_quat, {0, 1, 0, 0});
  CheckNear(m.geom_quat + 4, {half, 0, 0, half});
  CheckNear(m.geom_quat + 8, {1, 0, 0, 0});
  CheckNear(m.geom_pos + 9, {1, 0, 0});
  CheckNear(m.geom_quat + 12, {half, 0, 0, half});

  const Composed rods("<frame pos=\"0 0 1\"><geom/></frame>",
                      "<default><geom type=\"capsule\" size=\"0.1\" fromto=\"0 0 0 2 0 0\"/>"
                      "</default>");
  CheckNear(rods.model().geom_pos, {1, 0, 1});
  CheckNear(rods.model().geom_size, {0.1, 1});
}

TEST_CASE("a frame's class is that of what stands in it") {
  const Composed file(
      "<body childclass=\"big\"><frame childclass=\"small\">"
      "<geom/><geom class=\"big\"/><frame><body><geom/></body></frame>"
      "<frame childclass=\"main\"><geom/></frame>"
      "<body childclass=\"big\"><geom/></body></frame><geom/></body>",
      "<default><geom size=\"1\"/><default class=\"small\"><geom size=\"0.5\"/></default>"
      "<default class=\"big\"><geom size=\"2\"/></default></default>");
  const mjModel& m = file.model();
  Numbers sizes;
  for (int i = 0; i < m.ngeom; ++i) sizes.push_back(m.geom_size[3 * i]);
  CHECK(sizes == Numbers{0.5, 2, 1, 2, 0.5, 2});
}

TEST_CASE("a free joint has no place, and an inertial is the body's own") {
  const Composed file(
      "<frame pos=\"1 0 0\"><body pos=\"1 0 0\"><frame pos=\"5 0 0\"><freejoint/>"
      "<inertial mass=\"1\" pos=\"0 2 0\" diaginertia=\"1 1 1\"/></frame></body></frame>"
      "<body><frame pos=\"5 0 0\"><joint type=\"free\"/>" +
      kBall + "</frame></body>");
  const mjModel& m = file.model();
  CheckNear(m.qpos0, {2, 0, 0});
  CheckNear(m.body_ipos + 3, {0, 2, 0});
  CheckNear(m.jnt_pos, {0, 0, 0, 0, 0, 0});
}

TEST_CASE("what MuJoCo refuses in a frame is an error at its place, once") {
  const auto findings = [](const std::string& frame, const std::string& inside = "") {
    return Adapted("<worldbody>\n<frame " + frame + ">\n" + inside + "</frame></worldbody>")
        .findings;
  };
  CHECK(findings("pos=\"1 0\"") ==
        Strings{"3:8 error: 'pos' of the frame on line 3 must be 3 numbers"});
  CHECK(findings("quat=\"0 0 0 0\"") ==
        Strings{"3:8 error: 'quat' of the frame on line 3 must not be zero"});
  CHECK(findings("name=\"f\" quat=\"1 0 0 0\" zaxis=\"0 0 1\"") ==
        Strings{"3:32 error: 'zaxis' of frame 'f' is a second orientation"});
  CHECK(findings("zaxis=\"0 0 0\"") ==
        Strings{"3:8 error: 'zaxis' of the frame on line 3 has no direction"});
  CHECK(findings("axisangle=\"0 0 0 1\"").front().ends_with("has no direction"));
  CHECK(findings("xyaxes=\"1 0 0 2 0 0\"").front().ends_with("has no direction"));
  CHECK(findings("pos=\"0 0 0\"", "<geom size=\"1\" pos=\"x\"/>") ==
        Strings{"4:16 error: 'pos' of the geom on line 4 must be 3 numbers"});
  CHECK(Adapted("<compiler eulerseq=\"xyw\"/>\n"
                "<worldbody><frame euler=\"1 2 3\"/></worldbody>")
            .findings ==
        Strings{"3:19 error: 'euler' of the frame on line 3 cannot be read with eulerseq 'xyw'"});
}

TEST_CASE("what MuJoCo refuses of the ends of a geom, it refuses") {
  for (const std::string geom :
       {"type=\"sphere\" size=\"1\" fromto=\"0 0 0 1 0 0\"",
        "type=\"capsule\" size=\"1\" fromto=\"0 0 0 0 0 0\"",
        "type=\"capsule\" size=\"1\" fromto=\"0 0 0 1 0 0\" pos=\"1 0 0\""}) {
    INFO(geom);
    const Adapted file("<worldbody><frame pos=\"0 0 1\"><geom " + geom + "/></frame></worldbody>");
    CHECK(file.findings.empty());
    CHECK_FALSE(Engine().LoadText(file.text).model);
  }
}

TEST_CASE("a composite in a frame, and frames beside global coordinates, are errors") {
  CHECK(Adapted("<worldbody><frame>\n<composite prefix=\"c\" type=\"grid\" count=\"2 1 1\" "
                "spacing=\"1\"/></frame></worldbody>")
            .findings == Strings{"3:1 error: the composite on line 3 needs MuJoCo 3.3.1"});
  CHECK(Adapted("<compiler coordinate=\"global\"/><worldbody>\n<frame/></worldbody>").findings ==
        Strings{"3:1 error: the frame on line 3 needs MuJoCo 3.1.2"});
}

TEST_CASE("frames in other sections are left to MuJoCo") {
  CHECK(Adapted("<asset><frame/></asset>").Says("<asset><frame></frame></asset>"));
}

TEST_CASE("a release with replicate reads frames itself") {
  const std::string inner = "<worldbody><frame pos=\"0 0 1\"/></worldbody>";
  CHECK_FALSE(Adapted(inner, 315).changed);
  CHECK_FALSE(Adapted(inner, 314).Says("frame"));
}

}  // namespace
}  // namespace mjforge::engine
