// Films of simulated drops and drives.
#include "mjforge/physics/film_recorder.h"

#include <cmath>

#include "examined.h"
#include "mjforge/physics/behaviour.h"
#include "mjforge/physics/joint_drive.h"

namespace mjforge::physics {
namespace {

constexpr const char* kFloor = R"(<geom name="floor" type="plane" size="0 0 1"/>)";

// Returns at most `frames` positions of a film of the drop of these bodies.
Film FilmOfDrop(const std::string& bodies, const model::Checks& checks, std::size_t frames,
                const std::string& option = "") {
  const engine::Model m =
      Load(option + "<worldbody>" + std::string(kFloor) + bodies + "</worldbody>");
  const model::Object object = compiled::ObjectOf(*m, {}, compiled::Nameless::kNumbered);
  Workspace workspace;
  diag::Findings findings;
  static_checks::Reporter reporter(checks, findings);
  FilmRecorder recorder;
  Result result;
  RecordDrop({*m, workspace, object, {}, reporter, result}, recorder);
  return recorder.Finish(frames);
}

}  // namespace

TEST_CASE("a film of a drop begins above the floor and ends at rest on it") {
  const Film film = FilmOfDrop(Free(0.3, kCube), {}, 20);
  REQUIRE(film.positions.size() == 20);
  CHECK(film.positions.front()[2] == Approx(0.052).margin(1e-4));
  CHECK(film.positions.back()[2] == Approx(0.05).margin(2e-4));
  CHECK(film.time > 0.1);
  CHECK(film.time < 2);
}

TEST_CASE("a film has all positions if there are few, and none of an object that cannot step") {
  CHECK(FilmOfDrop(Free(0.3, kCube), {}, 10'000).positions.size() < 400);
  model::Checks checks;
  checks.settle_time = 1e9;
  CHECK(FilmOfDrop(Free(0.3, kCube), checks, 20).positions.empty());
}

TEST_CASE("a film is as long as the simulation, whatever the timestep") {
  const double time = FilmOfDrop(Free(0.3, kCube), {}, 20).time;
  const Film coarse = FilmOfDrop(Free(0.3, kCube), {}, 20, R"(<option timestep="0.01"/>)");
  CHECK(coarse.time == Approx(time).epsilon(0.3));
}

TEST_CASE("a film of a drop shows the nudge that topples the object") {
  const std::string pillar = Free(0.2, R"(<geom type="box" size="0.02 0.02 0.1"/>)");
  model::Checks checks;
  const Film stands = FilmOfDrop(pillar, checks, 40);
  CHECK(stands.positions.back()[2] == Approx(0.1).margin(1e-3));
  checks.stable = true;
  checks.nudge = 0.3;  // rad; more than the 0.2 at which it topples
  const Film topples = FilmOfDrop(pillar, checks, 40);
  CHECK(topples.positions.front() == stands.positions.front());
  CHECK(topples.positions.back()[2] == Approx(0.02).margin(1e-3));
}

TEST_CASE("a film of a drive goes to both ends of a joint's range, and moves no other joint") {
  const engine::Model m = Load(R"(<compiler angle="radian"/><worldbody>)" +
                               Free(0.3, kCube + R"(<body name="a" pos="0 0 0.2"><geom size="0.01"/>
        <joint name="slide" type="slide" axis="0 0 1" range="-0.04 0.08" limited="true"/></body>
        <body name="b" pos="0.3 0 0"><geom size="0.01"/>
        <joint name="hinge" axis="0 0 1" range="0 1" limited="true"/></body>)") +
                               "</worldbody>");
  const auto d = compiled::MakeData(*m);
  FilmRecorder recorder;
  CHECK(RecordDrive(*m, *d, "object", {}, 1, recorder));
  const Film film = recorder.Finish(100);
  double low = 0;
  double high = 0;
  double other = 0;
  for (const std::vector<double>& positions : film.positions) {
    low = std::min(low, positions[7]);
    high = std::max(high, positions[7]);
    other = std::max(other, std::abs(positions[8]));
  }
  CHECK(low == Approx(-0.04).margin(0.003));
  CHECK(high == Approx(0.08).margin(0.003));
  CHECK(other < 1e-3);
  CHECK(film.positions.back()[7] == Approx(0).margin(0.003));
  CHECK_FALSE(RecordDrive(*m, *d, "object", {}, 0, recorder));  // a free joint
}

}  // namespace mjforge::physics
