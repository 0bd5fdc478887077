#include "mjforge/attach/body_reader.h"

#include <cmath>
#include <string>

#include <mujoco/mujoco.h>
#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

const std::string kBall =
    "<body name=\"b\"><geom name=\"g\" size=\"0.1\" density=\"1000\"/></body>\n";

double MassWith(const std::string& compiler, const std::string& body = kBall) {
  Attaching files(Mjcf(body, "<compiler " + compiler + "/>\n"));
  return files.Get().bodies[0].mass_properties.mass;
}

TEST_CASE("a body has the mass that MuJoCo finds, whatever decides it") {
  const double ball = 4.0 / 3 * M_PI * 0.001 * 1000;
  const std::string stated =
      "<body name=\"b\"><inertial pos=\"0 0 0\" mass=\"2\" diaginertia=\"1 1 1\"/>"
      "<geom name=\"g\" size=\"0.1\"/></body>\n";
  CHECK(MassWith("") == Approx(ball));
  CHECK(MassWith("settotalmass=\"7\"") == Approx(7));
  CHECK(MassWith("boundmass=\"9\"") == Approx(9));
  CHECK(MassWith("", stated) == 2);
  CHECK(MassWith("inertiafromgeom=\"true\"", stated) == Approx(ball));
  CHECK(MassWith("inertiafromgeom=\"true\" inertiagrouprange=\"1 5\"") == 0);
}

TEST_CASE("a body states its inertia in its own frame") {
  Attaching files(
      Mjcf("<body name=\"b\"><inertial pos=\"1 2 3\" mass=\"2\" diaginertia=\"0.1 0.2 0.25\" "
           "euler=\"0 0 90\"/></body>\n"));
  const model::Body& b = files.Get().bodies[0];
  CHECK(b.explicit_inertial);
  CHECK(b.mass_properties.p_FCm == Eigen::Vector3d(1, 2, 3));
  CHECK(b.mass_properties.I_Cm_F.isApprox(
      Eigen::Matrix3d(Eigen::Vector3d(0.2, 0.1, 0.25).asDiagonal())));
}

TEST_CASE("an attached body keeps the axes of its inertia, in the order of its file") {
  Attaching files(
      Mjcf("<body name=\"b\"><inertial pos=\"1 2 3\" mass=\"2\" diaginertia=\"0.25 0.1 0.2\" "
           "euler=\"0 0 30\"/></body>\n"));
  const model::Body& b = files.Get().bodies[0];
  REQUIRE(b.principal_axes);
  CHECK(b.principal_axes->isApprox(
      Eigen::Quaterniond(Eigen::AngleAxisd(std::acos(-1) / 6, Eigen::Vector3d::UnitZ()))));
}

TEST_CASE("an inertia that cannot be is balanced where the file says so") {
  const std::string body =
      "<body name=\"b\"><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 7\"/></body>\n";
  Attaching refused(Mjcf(body));
  CHECK(refused.Try() == nullptr);
  Attaching files(Mjcf(body, "<compiler balanceinertia=\"true\"/>\n"));
  CHECK(files.Get().bodies[0].mass_properties.I_Cm_F.isApprox(3 * Eigen::Matrix3d::Identity()));
}

TEST_CASE("angles are in radians whatever the file's unit and order") {
  const std::string hinge =
      "<body name=\"b\"><joint name=\"j\" limited=\"true\" range=\"-90 45\" ref=\"30\"/>"
      "<geom size=\"1\" euler=\"0 90 90\"/></body>\n";
  Attaching degrees(Mjcf(hinge));
  const model::Body& b = degrees.Get().bodies[0];
  REQUIRE(b.joints[0].range);
  CHECK(b.joints[0].range->isApprox(Eigen::Vector2d(-M_PI / 2, M_PI / 4)));
  CHECK(Said(b.joints[0].attributes, "ref") == "0.5235987756");
  CHECK(b.parts[0].X_BG.q.isApprox(model::FromEuler({0, M_PI / 2, M_PI / 2})));
  Attaching radians(Mjcf(hinge, "<compiler angle=\"radian\" eulerseq=\"zyx\"/>\n"));
  const model::Body& r = radians.Get().bodies[0];
  CHECK(r.joints[0].range->isApprox(Eigen::Vector2d(-90, 45)));
  CHECK(r.parts[0].X_BG.q.isApprox(Eigen::AngleAxisd(90, Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(90, Eigen::Vector3d::UnitX())));
}

TEST_CASE("a range without `limited` holds, unless the file says that it does not") {
  const std::string ranged =
      "<body name=\"b\"><joint name=\"j\" range=\"0 45\"/><geom size=\"1\"/></body>\n";
  for (const std::string compiler : {"", "<compiler autolimits=\"true\"/>\n"}) {
    Attaching with(Mjcf(ranged, compiler));
    CHECK(with.Get().bodies[0].joints[0].range);
  }
  Attaching without(Mjcf(ranged, "<compiler autolimits=\"false\"/>\n"));
  CHECK(without.Try() == nullptr);
  Attaching off(
      Mjcf("<body name=\"b\"><joint name=\"j\" range=\"0 45\" limited=\"false\"/><geom size=\"1\"/>"
           "</body>\n"));
  CHECK_FALSE(off.Get().bodies[0].joints[0].range);
}

#if mjVERSION_HEADER < 300
TEST_CASE("global coordinates become local ones") {
  Attaching files(
      Mjcf("<body name=\"a\" pos=\"1 0 0\"><geom name=\"g\" size=\"1\" pos=\"1 2 0\"/>"
           "<body name=\"b\" pos=\"1 0 3\"><joint name=\"j\" pos=\"1 0 4\"/>"
           "<geom size=\"1\"/></body></body>\n",
           "<compiler coordinate=\"global\"/>\n"));
  const model::Attachment& a = files.Get();
  CHECK(a.bodies[0].parts[0].X_BG.p == Eigen::Vector3d(0, 2, 0));
  CHECK(a.bodies[1].X_PB.p == Eigen::Vector3d(0, 0, 3));
  CHECK(a.bodies[1].joints[0].pos == Eigen::Vector3d(0, 0, 1));
}
#endif  // later releases reject them

TEST_CASE("a joint says what differs from MuJoCo's defaults, and no more") {
  Attaching files(
      Mjcf("<body name=\"a\"><freejoint name=\"f\"/><geom size=\"1\"/><body name=\"b\">"
           "<joint name=\"p\"/>"
           "<joint name=\"q\" type=\"slide\" axis=\"0 3 4\" pos=\"1 2 3\" damping=\"0.5\" "
           "stiffness=\"2\" springref=\"0.1\" armature=\"0.3\" frictionloss=\"0.4\" group=\"2\" "
           "margin=\"0.01\" solreflimit=\"0.03 0.8\" solimpfriction=\"0.8 0.9 0.01 0.4 3\" "
           "user=\"1 0 2 0\"/><geom size=\"1\"/></body></body>\n"));
  const model::Attachment& a = files.Get();
  CHECK(a.root_joints == std::vector<std::string>{"f"});
  CHECK(a.bodies[0].joints[0].type == "free");
  const model::Joint& p = a.bodies[1].joints[0];
  CHECK(p.type == "hinge");
  CHECK(p.attributes.empty());
  const model::Joint& q = a.bodies[1].joints[1];
  CHECK(q.type == "slide");
  CHECK(q.axis.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  CHECK(q.pos == Eigen::Vector3d(1, 2, 3));
  CHECK(Said(q.attributes) ==
        "group=2 stiffness=2 damping=0.5 frictionloss=0.4 armature=0.3 springref=0.1 margin=0.01 "
        "solreflimit=0.03 0.8 solimpfriction=0.8 0.9 0.01 0.4 3 user=1 0 2");
}

TEST_CASE("default classes are resolved, nested ones and childclass, too") {
  Attaching files(Mjcf(
      "<body name=\"a\" childclass=\"soft\"><geom name=\"g\" size=\"1\"/>"
      "<geom name=\"h\" class=\"main\" size=\"1\"/><geom name=\"i\" class=\"softer\"/></body>\n",
      "<default><geom condim=\"4\"/><default class=\"soft\"><geom friction=\"0.5 0.1 0.1\"/>"
      "<default class=\"softer\"><geom size=\"3\" rgba=\"0.1 0.2 0.3 1\"/></default></default>"
      "</default>\n"));
  const std::vector<model::Part>& parts = files.Get().bodies[0].parts;
  CHECK(Said(parts[0].attributes) == "condim=4 friction=0.5 0.1 0.1");
  CHECK(Said(parts[1].attributes) == "condim=4");
  CHECK(Said(parts[2].attributes) == "condim=4 friction=0.5 0.1 0.1 rgba=0.1 0.2 0.3 1");
  CHECK(parts[2].shape.size.x() == 3);
}

TEST_CASE("a geom is a part as it is, with no mass of its own") {
  Attaching files(
      Mjcf("<body name=\"a\"><geom name=\"g\" type=\"capsule\" fromto=\"0 0 0 0 0 2\" size=\"0.1\" "
           "mass=\"5\"/><geom name=\"h\" type=\"box\" size=\"1 2 3\" contype=\"0\" "
           "conaffinity=\"0\" group=\"4\"/><geom name=\"i\" type=\"ellipsoid\" size=\"1 2 3\" "
           "contype=\"0\" fluidshape=\"ellipsoid\"/></body>\n"));
  const std::vector<model::Part>& parts = files.Get().bodies[0].parts;
  CHECK(parts[0].as_is);
  CHECK(parts[0].mass == 0);
  CHECK(parts[0].density == 0);
  CHECK(parts[0].role == model::Role::kCollision);
  CHECK(parts[0].shape.type == model::GeomType::kCapsule);
  CHECK(parts[0].shape.size == Eigen::Vector3d(0.1, 1, 0));
  CHECK(parts[0].X_BG.p == Eigen::Vector3d(0, 0, 1));
  CHECK(parts[1].role == model::Role::kVisual);
  CHECK(Said(parts[1].attributes) == "contype=0 conaffinity=0 group=4");
  CHECK(parts[2].role == model::Role::kCollision);
  CHECK(Said(parts[2].attributes) == "contype=0 fluidshape=ellipsoid");
}

TEST_CASE("geoms that the file throws away are not taken") {
  Attaching files(
      Mjcf("<body name=\"a\"><geom name=\"g\" size=\"1\"/><geom name=\"h\" size=\"1\" "
           "contype=\"0\" conaffinity=\"0\"/></body>\n",
           "<compiler discardvisual=\"true\"/>\n"));
  CHECK(Names(files.Get().bodies[0].parts) == "g");
}

TEST_CASE("bodies that the file fuses are one") {
  Attaching files(
      Mjcf("<body name=\"a\"><joint/><geom name=\"g\" size=\"1\"/>"
           "<body name=\"b\" pos=\"1 0 0\"><geom name=\"h\" size=\"1\"/></body></body>\n",
           "<compiler fusestatic=\"true\"/>\n"));
  const model::Attachment& a = files.Get();
  CHECK(Names(a.bodies) == "a");
  CHECK(Names(a.bodies[0].parts) == "g h");
  CHECK(a.bodies[0].parts[1].X_BG.p == Eigen::Vector3d(1, 0, 0));
  CHECK(files.Try("b") == nullptr);
  CHECK(files.OnlyFinding() ==
        "error attach/no-body: 'arm.xml' has no body 'b' (the file's compiler setting fusestatic "
        "merges it with its parent)");
}

TEST_CASE("sites, cameras and lights go with their bodies") {
  Attaching files(
      Mjcf("<body name=\"a\" user=\"1 2\"><geom size=\"1\"/>"
           "<site name=\"s\" type=\"box\" size=\"1 2 3\" pos=\"1 0 0\" group=\"3\"/>"
           "<camera name=\"c\" fovy=\"60\" pos=\"0 0 1\" mode=\"targetbody\" target=\"b\"/>"
           "<camera name=\"d\" mode=\"targetbody\" target=\"z\"/>"
           "<light name=\"l\" directional=\"true\" dir=\"0 0 -2\" cutoff=\"30\"/>"
           "<body name=\"b\"><geom size=\"1\"/></body></body>\n"
           "<body name=\"z\"><geom size=\"1\"/></body>\n"));
  const model::Body& a = files.Get().bodies[0];
  CHECK(Said(a.attributes) == "user=1 2");
  CHECK(a.sites[0].size == Eigen::Vector3d(1, 2, 3));
  CHECK(Said(a.sites[0].attributes) == "group=3");
  REQUIRE(Names(a.elements) == "c l");
  CHECK(Said(a.elements[0].attributes) == "mode=targetbody target=b pos=0 0 1 fovy=60");
  CHECK(a.elements[0].attributes[1].refers == "body");
  CHECK(Said(a.elements[1].attributes) == "pos=0 0 0 dir=0 0 -1 directional=true cutoff=30");
  CHECK(files.OnlyFinding() ==
        "warning attach/not-carried: camera 'd' of 'arm.xml' is not carried over: its target, body "
        "'z', is not attached [arm.xml:3:174 here]");
}

}  // namespace
}  // namespace mjforge::attach
