#include "mjforge/backport/mesh_inertia.h"
#include "mjforge/backport/model_file.h"

#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {
namespace {

const std::string kCorner = "vertex=\"0 0 0 1 0 0 0 1 0 0 0 1\"";
const std::string kOutwards = "face=\"0 2 1 0 1 3 0 3 2 1 2 3\"";

/// Compiles a body of these geoms. The mesh `m` is the corner of a cube.
engine::Loaded Weighed(const std::string& geoms, const std::string& faces = kOutwards,
                       const std::string& sections = "") {
  const harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
  std::optional<xml::XmlElement> root = xml::ReadXml(
      folder.Write("m.xml", "<mujoco>" + sections + "<asset><mesh name=\"m\" " + kCorner + " " +
                                faces + "/></asset><worldbody><body name=\"b\"><freejoint/>" +
                                geoms + "</body></worldbody></mujoco>"),
      sources, findings);
  REQUIRE(root);
  engine::Engine engine;
  AddMeshInertia(*root, [&](const std::string& text) { return engine.LoadText(text); });
  engine::Loaded loaded = engine.LoadText(xml::Flatten(*root).text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return loaded;
}

const std::string kMesh = "<geom type=\"mesh\" mesh=\"m\"/>";

TEST_CASE("a mesh weighs what its volume does") {
  const engine::Loaded loaded = Weighed(kMesh);
  const mjModel& m = *loaded.model;
  CHECK(m.body_mass[1] == Approx(1000.0 / 6));
  for (int i = 0; i < 3; ++i) CHECK(m.body_ipos[3 + i] == Approx(0.25));
  // Along each axis the mean square is 1/10, the mean 1/4.
  const double sum = m.body_inertia[3] + m.body_inertia[4] + m.body_inertia[5];
  CHECK(sum == Approx(1000.0 / 6 * 2 * 3 * (1.0 / 10 - 1.0 / 16)));
}

TEST_CASE("whichever way its faces look") {
  const engine::Loaded loaded = Weighed(kMesh, "face=\"0 1 2 0 1 3 0 3 2 1 2 3\"");
  CHECK(loaded.model->body_mass[1] == Approx(1000.0 / 6));
  CHECK(loaded.model->body_ipos[3] == Approx(0.25));
}

TEST_CASE("with the mass, density and pose of each geom, among others") {
  const engine::Loaded loaded = Weighed(
      "<geom type=\"mesh\" mesh=\"m\" mass=\"2\" pos=\"1 0 0\"/>"
      "<geom class=\"light\" mesh=\"m\" euler=\"0 0 90\"/>"
      "<geom type=\"box\" size=\"0.5 0.5 0.5\" density=\"1\"/>",
      kOutwards,
      "<default><default class=\"light\"><geom type=\"mesh\" density=\"6\"/></default>"
      "</default>");
  const mjModel& m = *loaded.model;
  CHECK(m.body_mass[1] == Approx(2 + 1 + 1));
  CHECK(m.body_ipos[3] == Approx((2 * 1.25 - 0.25) / 4));
  CHECK(m.body_ipos[4] == Approx((2 * 0.25 + 0.25) / 4));
}

/// A corner of a cube with a dent in its slanted face, hinged and turned about z.
std::string Dented(const std::string& attributes, const std::string& defaults = "") {
  return "<default>" + defaults + "</default><asset><mesh name=\"m\" " + attributes +
         " vertex=\"0 0 0 1 0 0 0 1 0 0 0 1 .2 .2 .2\" face=\"0 2 1 0 1 3 0 3 2 1 2 4 2 3 4 3 1 "
         "4\"/></asset><worldbody><body name=\"b\"><joint/><geom type=\"mesh\" mesh=\"m\" pos=\"0 "
         "0 1\" euler=\"0 0 90\" contype=\"0\"/></body></worldbody>";
}

/// Backports and compiles the file of a mesh with an attribute `inertia`.
engine::Loaded LoadBackported(const std::string& inner) {
  const harness::TemporaryFolder folder;
  engine::Engine engine;
  return LoadFile(engine, folder.Write("m.xml", "<mujoco>" + inner + "</mujoco>"));
}

TEST_CASE("a mesh weighs what its kind of inertia says") {
  struct Expected {
    std::string kind;
    double mass;    // kg
    double centre;  // m
    double largest;
    double smallest;  // principal moments, kg m^2
  };
  // MuJoCo 3.3.7 computes these numbers.
  const Expected all[] = {{"legacy", 137.0686841, 0.23706869, 13.70686841, 8.34004867},
                          {"exact", 100, 0.21666667, 10, 6.11666676},
                          {"convex", 166.6666667, 0.25, 16.66666667, 10.41666667},
                          {"shell", 2494.987432, 0.24880853, 415.83123862, 246.61739944}};
  for (const auto& [kind, mass, centre, largest, smallest] : all) {
    INFO(kind);
    const std::string inertia = "inertia=\"" + kind + "\"";
    const bool of_class = kind == "shell";
    const engine::Loaded loaded =
        LoadBackported(of_class ? Dented("", "<mesh " + inertia + "/>") : Dented(inertia));
    INFO(loaded.error);
    REQUIRE(loaded.model);
    const mjModel& m = *loaded.model;
    CHECK(m.body_mass[1] == Approx(mass));
    CHECK(m.body_ipos[3] == Approx(-centre));
    CHECK(m.body_ipos[5] == Approx(1 + centre));
    CHECK(m.body_inertia[3] == Approx(largest));
    CHECK(m.body_inertia[5] == Approx(smallest));
  }
}

TEST_CASE("an open mesh weighs what its kind of inertia says") {
  struct Expected {
    std::string kind;
    double mass;    // kg
    double height;  // of the centre of mass, m
    double largest;
    double smallest;  // principal moments, kg m^2
  };
  // MuJoCo 3.3.7 computes these numbers.
  const Expected all[] = {{"legacy", 3206.349206, 0.4047619048, 2349.206349, 1375.499406},
                          {"exact", 3206.349206, 0.4047619048, 2349.206349, 1375.499406},
                          {"convex", 4000, 0.5, 2666.666667, 1666.666667},
                          {"shell", 12000, 0.3333333333, 13333.33333, 8000}};
  for (const auto& [kind, mass, height, largest, smallest] : all) {
    INFO(kind);
    const engine::Loaded loaded = LoadBackported(
        "<asset><mesh name=\"m\" inertia=\"" + kind +
        "\" vertex=\"-1 -1 0 1 -1 0 1 1 0 -1 1 0 -1 -1 1 1 -1 1 1 1 1 -1 1 1\" face=\"0 2 1 0 3 2 "
        "0 "
        "1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7\"/></asset><worldbody><body><freejoint/>"
        "<geom type=\"mesh\" mesh=\"m\" pos=\"0 0 5\"/></body></worldbody>");
    INFO(loaded.error);
    REQUIRE(loaded.model);
    const mjModel& m = *loaded.model;
    CHECK(m.body_mass[1] == Approx(mass));
    CHECK(m.body_ipos[5] == Approx(5 + height));
    CHECK(m.body_inertia[3] == Approx(largest));
    CHECK(m.body_inertia[5] == Approx(smallest));
  }
}

TEST_CASE("a flat mesh can be a shell") {
  const engine::Loaded loaded = LoadBackported(
      "<asset><mesh name=\"m\" inertia=\"shell\" vertex=\"0 0 0 1 0 0 1 2 0 0 2 0\" face=\"0 1 2 0 "
      "2 "
      "3\"/></asset><worldbody><body><joint/><geom type=\"mesh\" mesh=\"m\" contype=\"0\" "
      "conaffinity=\"0\" mass=\"3\"/></body></worldbody>");
  INFO(loaded.error);
  REQUIRE(loaded.model);
  CHECK(loaded.model->body_ipos[4] == Approx(1));
  CHECK(loaded.model->body_inertia[3] == Approx(3 * (1 + 4) / 12.0));
}

TEST_CASE("a kind of inertia that matters where it cannot be applied is an error") {
  if (mjVERSION_HEADER >= 330) return;  // MuJoCo applies it
  const std::string needs = "needs MuJoCo 3.3.0";
  CHECK(LoadBackported("<compiler coordinate=\"global\"/>" + Dented("inertia=\"shell\""))
            .error.ends_with(needs));
  CHECK(LoadBackported("<default><geom shellinertia=\"true\"/></default>" +
                       Dented("inertia=\"shell\""))
            .error.ends_with(needs));
}

TEST_CASE("a kind of inertia is applied where geoms replace inertias") {
  const engine::Loaded loaded =
      LoadBackported("<compiler inertiafromgeom=\"true\"/>" + Dented("inertia=\"exact\""));
  INFO(loaded.error);
  REQUIRE(loaded.model);
  CHECK(loaded.model->body_mass[1] == Approx(100));
}

TEST_CASE("a body that has its mass from a composite does not hide the masses of meshes") {
  if (mjVERSION_HEADER >= 300) return;  // MuJoCo computes the masses
  const engine::Loaded loaded = LoadBackported(
      Dented("inertia=\"exact\"") +
      "<worldbody><body name=\"soft\" pos=\"0 0 9\"><freejoint/><composite type=\"box\" "
      "count=\"4 4 4\" spacing=\"0.04\"><geom type=\"capsule\" size=\".015 .05\"/></composite>"
      "</body></worldbody>");
  INFO(loaded.error);
  REQUIRE(loaded.model);
  CHECK(loaded.model->body_mass[1] == Approx(100));
}

TEST_CASE("MuJoCo's reason to reject a file is not the attribute `inertia`") {
  if (mjVERSION_HEADER >= 300) return;  // MuJoCo has the attribute
  const engine::Loaded loaded = LoadBackported(
      "<asset><mesh name=\"m\" file=\"missing.obj\" inertia=\"convex\"/></asset>"
      "<worldbody><body><freejoint/><geom type=\"mesh\" mesh=\"m\"/></body></worldbody>");
  CHECK(loaded.error.find("missing.obj") != std::string::npos);
}

TEST_CASE("what has an inertia, or no mass, is left alone") {
  const std::string inertial = "<inertial pos=\"0 0 0\" mass=\"3\" diaginertia=\"1 1 1\"/>";
  CHECK(Weighed(inertial + kMesh).model->body_mass[1] == 3);
  const engine::Loaded loaded =
      Weighed("<geom type=\"mesh\" mesh=\"m\" mass=\"0\"/><geom size=\"0.1\"/>");
  CHECK(loaded.model->body_ipos[3] == 0);
}

const std::string kBall =
    "<body name=\"body0\" pos=\"0 0 2\"><joint/><geom size=\"0.1\" mass=\"1\"/></body>";

TEST_CASE("a total mass is shared as by later releases") {
  const engine::Loaded loaded =
      Weighed(kMesh + kBall, kOutwards, "<compiler settotalmass=\"20\"/>");
  const double mesh = 1000.0 / 6;
  CHECK(loaded.model->body_mass[1] == Approx(20 * mesh / (mesh + 1)));
  CHECK(loaded.model->body_mass[2] == Approx(20 / (mesh + 1)));
}

TEST_CASE("geoms replace inertias if the compiler says so") {
  const std::string inertial = "<inertial pos=\"0 0 0\" mass=\"3\" diaginertia=\"1 1 1\"/>";
  const std::string stated = "<body><joint/>" + inertial + "<geom size=\"0.1\" mass=\"1\"/></body>";
  const std::string bare = "<body><joint/>" + inertial + "</body>";
  const engine::Loaded loaded =
      Weighed(inertial + kMesh + stated + bare, kOutwards, "<compiler inertiafromgeom=\"true\"/>");
  CHECK(loaded.model->body_mass[1] == Approx(1000.0 / 6));
  CHECK(loaded.model->body_mass[2] == 1);
  CHECK(loaded.model->body_mass[3] == 3);
}

TEST_CASE("discarded geoms have a mass") {
  const engine::Loaded loaded = Weighed(
      "<geom type=\"mesh\" mesh=\"m\" contype=\"0\" conaffinity=\"0\"/><geom size=\"0.1\" "
      "mass=\"2\"/>"
      "<body><joint/><geom size=\"0.1\" mass=\"1\" contype=\"0\" conaffinity=\"0\"/></body>",
      kOutwards, "<compiler discardvisual=\"true\"/>");
  CHECK(loaded.model->ngeom == 1);
  CHECK(loaded.model->body_mass[1] == Approx(2 + 1000.0 / 6));
  CHECK(loaded.model->body_mass[2] == 1);
}

TEST_CASE("a body fused with its parent counts once") {
  const engine::Loaded loaded = Weighed("<geom size=\"0.1\" mass=\"2\"/><body>" + kMesh + "</body>",
                                        kOutwards, "<compiler fusestatic=\"true\"/>");
  CHECK(loaded.model->nbody == 2);
  CHECK(loaded.model->body_mass[1] == Approx(2 + 1000.0 / 6));
}

}  // namespace
}  // namespace mjforge::backport
