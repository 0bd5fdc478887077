// Drop tests: rest, tilt, drift, energy, contacts and the floor.
#include <cmath>
#include <numbers>

#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

TEST_CASE("a cube comes to rest on the floor where it was put down") {
  const Examined cube = Examine(Free(7, kCube));
  REQUIRE(cube.result);
  CHECK(cube.Codes().empty());
  const Result& result = *cube.result;
  CHECK(result.dropped);
  CHECK(result.at_rest);
  CHECK(result.time < 0.5);
  CHECK(result.tilt == 0);
  CHECK(result.drift == 0);
  CHECK(result.speed < 0.01);
  CHECK(result.ncon == 4);
  CHECK(result.nefc == 16);  // four sides of a pyramid per contact
  CHECK(result.energy_gain < 1e-4);
  // After a fall of 2 mm the cube lands at 0.2 m/s; the depth is less than that speed times the
  // time constant of the contact.
  CHECK(result.penetration > 0.0005);
  CHECK(result.penetration < 0.2 * 0.02);
  CHECK(result.sink < 0.0002);
  CHECK(result.joints.empty());
}

TEST_CASE("a box on its edge topples by what is left to a side") {
  const double angle = 0.9;  // rad; the box falls to the nearer side, at pi/2
  const Examined box =
      Examine(Free(1, "<geom type=\"box\" size=\"0.05 0.05 0.05\" euler=\"0.9 0 0\"/>"));
  REQUIRE(box.result);
  CHECK(box.result->at_rest);
  CHECK(box.result->tilt == Approx(std::numbers::pi / 2 - angle).margin(0.01));
  CHECK(box.result->drift > 0.001);
  CHECK(box.Codes().empty());
  model::Checks checks;
  checks.stable = true;
  checks.drift = 0.0001;
  const Examined strict = Examine(
      Free(1, "<geom type=\"box\" size=\"0.05 0.05 0.05\" euler=\"0.9 0 0\"/>"), {}, checks);
  CHECK(strict.Codes() == Strings{"error physics/topples", "error physics/drifts"});
}

TEST_CASE("a plane of the file's own is the floor, wherever it is") {
  const Examined cube = Examine(
      "<geom name=\"floor\" type=\"plane\" size=\"1 1 1\" pos=\"0 0 -3\"/>" + Free(7, kCube));
  REQUIRE(cube.result);
  CHECK(cube.result->at_rest);
  CHECK(cube.result->ncon == 4);
  CHECK(cube.result->time < 0.5);  // not after a fall of 10 m
}

TEST_CASE("what lies on a table is simulated where it lies") {
  const Examined cube = Examine(
      "<geom type=\"plane\" size=\"1 1 1\"/><geom type=\"box\" size=\"1 1 1\" pos=\"0 0 1\"/>" +
      Free(2.051, kCube));
  REQUIRE(cube.result);
  CHECK(cube.result->dropped);
  CHECK(cube.result->at_rest);
  CHECK(cube.result->drift < 0.001);
}

TEST_CASE("what touches nothing is not dropped") {
  const Examined ghost =
      Examine(Free(1, R"(<geom type="box" size="0.05 0.05 0.05" contype="0" conaffinity="0"/>)"));
  REQUIRE(ghost.result);
  CHECK_FALSE(ghost.result->dropped);
  CHECK(ghost.Codes().empty());
}

TEST_CASE("what is fixed to the world is not dropped, and needs no floor") {
  const Examined post = Examine("<body name=\"post\">" + kCube + "</body>");
  REQUIRE(post.result);
  CHECK_FALSE(post.result->dropped);
  CHECK(post.result->at_rest);
  CHECK(post.result->ncon == 0);
}

TEST_CASE("an undamped pendulum on a foot does not come to rest") {
  const std::string pendulum =
      kCube +
      "<body name=\"rod\" pos=\"0 0.06 0.07\"><joint name=\"swing\" axis=\"0 1 0\"/>"
      "<geom type=\"capsule\" fromto=\"0 0 0 0.1 0 0\" size=\"0.004\"/></body>";
  const Examined free = Examine(Free(0, pendulum));
  REQUIRE(free.result);
  CHECK_FALSE(free.result->at_rest);
  CHECK(free.result->time == 3);
  CHECK(free.result->speed > 0.01);
  CHECK(free.Codes() == Strings{"warning physics/not-at-rest"});
  model::Checks patient;
  patient.settle_time = 0.5;
  CHECK(Examine(Free(0, pendulum), {}, patient).result->time == 0.5);
}

TEST_CASE("a lid that creeps shut does not rest where it is at the moment") {
  const auto codes = [](const std::string& damping, double settle_time) {
    // The lid starts at 1 rad, and its weight shuts it.
    const std::string lid =
        "<body name=\"lid\" pos=\"-0.2 0 0.21\" euler=\"0 -1 0\">"
        "<joint name=\"hinge\" axis=\"0 -1 0\" limited=\"true\" range=\"0 1.7\" ref=\"1\" "
        "damping=\"" +
        damping + "\"/><geom type=\"box\" size=\"0.2 0.18 0.008\" pos=\"0.2 0 0\"/></body>";
    model::Checks checks;
    checks.drive = false;
    checks.settle_time = settle_time;
    checks.joints = {{.joints = {"hinge"}, .rests = Eigen::Vector2d(0.9, 1.1)}};
    const std::string base = "<body name=\"base\"><geom type=\"box\" size=\"0.2 0.18 0.2\"/>";
    return Examine(base + lid + "</body>", {}, checks).Codes();
  };
  using Codes = std::vector<std::string>;
  CHECK(codes("0", 0.2) == Codes{"warning physics/not-at-rest", "error physics/joint-rests"});
  CHECK(codes("150", 0.5) == Codes{"error physics/joint-rests"});
  CHECK(codes("1e6", 0.5) == Codes{"warning physics/joint-heavy"});
}

TEST_CASE("a spring that its timestep cannot follow is an error, and the end of it") {
  const Examined spring = Examine(
      Free(0, kCube + "<body name=\"head\" pos=\"0 0 0.2\"><joint name=\"slide\" type=\"slide\" "
                      "stiffness=\"1e9\" springref=\"0.1\"/><geom size=\"0.005\"/></body>"));
  REQUIRE(spring.result);
  REQUIRE_FALSE(spring.findings.empty());
  CHECK(spring.Codes().front() == "error physics/unstable");
  CHECK(spring.result->joints.empty());
}

TEST_CASE("an actuator that lifts without a command gains energy") {
  const Examined jack = Examine(
      Free(0, kCube +
                  "<body name=\"lift\" pos=\"0 0 0.09\"><joint name=\"screw\" type=\"slide\" "
                  "damping=\"5\" limited=\"true\" range=\"0 0.3\"/><geom size=\"0.03\"/></body>"),
      "<actuator><general joint=\"screw\" biastype=\"affine\" biasprm=\"40 0 0\"/></actuator>");
  CHECK(jack.Codes() == Strings{"error physics/gains-energy"});
  CHECK(jack.result->energy_gain > 0.02);
}

TEST_CASE("soft contacts sink, and hard landings go deep") {
  const std::string soft = Free(0, R"(<geom type="box" size="0.05 0.05 0.05" solref="0.3 1"/>)");
  const Examined sunk = Examine(soft);
  CHECK(sunk.Codes() == Strings{"error physics/sinks"});
  CHECK(sunk.result->sink > 0.001);
  model::Checks checks;
  checks.sink = 1;
  checks.penetration = 0.001;
  CHECK(Examine(Free(0, kCube), {}, checks).Codes() == Strings{"error physics/penetrates"});
}

TEST_CASE("an object with more contacts than MuJoCo has room for gets more room") {
  std::string legs;
  for (int i = 0; i < 15; ++i) {
    for (int k = 0; k < 15; ++k) {
      legs += "<geom type=\"box\" size=\"0.004 0.004 0.02\" pos=\"" + std::to_string(0.01 * i) +
              " " + std::to_string(0.01 * k) + " 0\"/>";
    }
  }
  const Examined brush = Examine(Free(0, legs));
  REQUIRE(brush.result);
  CHECK(brush.result->ncon == 4 * 15 * 15);
  CHECK(brush.result->at_rest);
  CHECK(brush.Codes().empty() == false);  // the legs do not touch each other
  for (const std::string& code : brush.Codes()) CHECK(code == "warning physics/loose");
}

const std::string kPlain =
    R"(<geom type="box" size="0.05 0.05 0.05" contype="1" conaffinity="1" solref="0.02 1"/>)";

TEST_CASE("the floor is the same whatever the file's defaults say") {
  const Examined plain = Examine(Free(1, kPlain));
  const std::string defaults =
      "<default><geom contype=\"0\" conaffinity=\"0\" solref=\"0.5 1\" friction=\"0\"/></default>";
  const Examined odd =
      Examine(Free(1, R"(<geom type="box" size="0.05 0.05 0.05" contype="1" conaffinity="1" )"
                      R"(solref="0.02 1" friction="1 0.005 0.0001"/>)"),
              defaults);
  REQUIRE(odd.result);
  CHECK(odd.result == plain.result);
}

TEST_CASE("a geom may have the floor's name") {
  CHECK(Examine(Free(1, R"(<geom name="mjforge-floor" size="0.05"/>)")).result->at_rest);
}

TEST_CASE("several free bodies have a floor below all of them") {
  const std::string two =
      Free(-2, kCube) +
      "<body name=\"other\" pos=\"1 0 -1.9\"><freejoint/><geom size=\"0.05\"/></body>";
  const Examined both = Examine(two);
  REQUIRE(both.result);
  CHECK(both.result->at_rest);
  CHECK(both.result->energy_gain < 1e-3);
  CHECK(both.Codes().empty());
}

TEST_CASE("several free bodies are dropped together, and keep their places") {
  const Examined both =
      Examine(Free(3, kCube) +
              "<body name=\"on_it\" pos=\"0 0 3.1\"><freejoint/><geom type=\"box\" size=\"0.05 "
              "0.05 0.05\"/></body><geom type=\"plane\" size=\"0 0 1\"/>");
  REQUIRE(both.result);
  CHECK(both.result->at_rest);
  CHECK(both.result->time < 0.6);  // a fall from 3 m takes as long
  CHECK(both.result->drift < 1e-4);
}

TEST_CASE("the drop begins in the start pose") {
  const std::string pendulum =
      R"(<body><geom type="box" size="0.1 0.1 0.01"/><body pos="0 0 0.2"><joint axis="0 1 0")"
      R"( damping="0.0005"/><geom type="capsule" fromto="0 0 0 0 0 0.1" size="0.01"/></body></body>)";
  const auto key = [](const char* name) {
    return "<keyframe><key name=\"" + std::string(name) + "\" qpos=\"1.57\"/></keyframe>";
  };
  // The pendulum stays upright, but swings if it starts at the side.
  CHECK(Examine(pendulum, key("other")).result->at_rest);
  CHECK(Examine(pendulum, key("m_start")).result->time >
        2 * Examine(pendulum, key("other")).result->time);
}

TEST_CASE("the start pose goes with a file that gets a floor") {
  const std::string flag =
      Free(1, std::string(kCube) +
                  R"(<body pos="0 0 0.1"><joint axis="0 1 0" damping="0.0005"/>)"
                  R"(<geom type="capsule" fromto="0 0 0 0 0 0.1" size="0.01"/></body>)");
  const auto time = [&](const char* name) {
    return Examine(flag, "<keyframe><key name=\"" + std::string(name) +
                             "\" qpos=\"0 0 1 1 0 0 0 1.2\"/></keyframe>")
        .result->time;
  };
  CHECK(time("m_start") != time("other"));
}

TEST_CASE("steps that are none, or longer than a fall, are an error") {
  for (const std::string timestep : {"0", "-1", "0.5", "1e-9"}) {
    CAPTURE(timestep);
    const Examined cube = Examine(Free(1, kCube), "<option timestep=\"" + timestep + "\"/>");
    CHECK(cube.Codes() == Strings{"error physics/unstable"});
    CHECK_FALSE(cube.result->dropped);
  }
  model::Checks checks;
  checks.settle_time = 1e9;
  CHECK(Examine(Free(1, kCube), {}, checks).Codes() == Strings{"error physics/unstable"});
}

TEST_CASE("what falls for ever is told so") {
  const Examined cube = Examine(Free(1, kCube), "<option gravity=\"0 0 1\"/>");
  REQUIRE(cube.findings.size() == 1);
  CHECK(cube.findings[0].message == "'m' touches nothing for 3 s and ends at 3 m/s");
}

TEST_CASE("a drop begins outside of margins") {
  const Examined ball = Examine(Free(1, R"(<geom size="0.05" margin="0.1"/>)"));
  CHECK(ball.Codes().empty());
  CHECK(ball.result->at_rest);
}

}  // namespace
}  // namespace mjforge::physics
