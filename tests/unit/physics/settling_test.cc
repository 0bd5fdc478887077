// Settling tests: which free bodies stay where they start.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

constexpr const char* kTable =
    R"(<body name="m_table"><geom type="box" size="0.2 0.2 0.01" pos="0 0 0.5"/></body>)";

// A cube of 4 cm with its middle at this height above the table, m.
std::string Cube(const char* name, double height, double x = 0) {
  return std::string("<body name=\"m_") + name + "\" pos=\"" + std::to_string(x) + " 0 " +
         std::to_string(0.51 + height) +
         "\"><freejoint/><geom type=\"box\" size=\"0.02 0.02 0.02\"/></body>";
}

model::Checks Settled(double time = 2) {
  model::Checks checks;
  checks.settled.emplace().time = time;
  return checks;
}

TEST_CASE("bodies that rest on a table and on each other stay") {
  const Examined stack = Examine(kTable + Cube("lower", 0.02) + Cube("upper", 0.06), {}, Settled());
  CHECK(stack.Codes().empty());
  REQUIRE(stack.result);
  REQUIRE(stack.result->settled);
  CHECK(stack.result->settled->bodies == 2);
  CHECK(stack.result->settled->moved == 0);
  CHECK(stack.result->settled->distance < 0.001);
}

TEST_CASE("without the check, nothing is measured") {
  CHECK_FALSE(Examine(kTable + Cube("lower", 0.02)).result->settled);
}

TEST_CASE("a body that falls is reported with the way that it fell") {
  const Examined high = Examine(kTable + Cube("cube", 0.03), {}, Settled());
  CHECK(high.Codes() == Strings{"error physics/not-settled"});
  CHECK(high.result->settled->moved == 1);
  CHECK(high.result->settled->distance == Approx(0.01).margin(3e-4));
  CHECK(high.findings.begin()->message.starts_with("'cube' moves by 10"));
}

TEST_CASE("a body that tips over an edge names what it stands on") {
  const Examined edge = Examine(kTable + Cube("cube", 0.02, 0.205), {}, Settled(1));
  CHECK(edge.Codes() == Strings{"error physics/not-settled"});
  CHECK(edge.result->settled->angle > 0.5);
  CHECK(edge.findings.begin()->message.ends_with("within 1 s; it stands on 'table'"));
}

TEST_CASE("a supporting body is named, not the root of its tree") {
  const std::string leg =
      R"(<body name="m_leg"><geom type="box" size="0.01 0.01 0.1" pos="0 0 0.1"/>)"
      R"(<body name="m_shelf"><geom type="box" size="0.2 0.2 0.01" pos="0 0 0.5"/></body></body>)";
  const Examined edge = Examine(leg + Cube("cube", 0.02, 0.205), {}, Settled(1));
  REQUIRE(edge.Codes() == Strings{"error physics/not-settled"});
  CHECK(edge.findings.begin()->message.ends_with("within 1 s; it stands on 'shelf'"));
}

TEST_CASE("too many steps are refused") {
  const Examined long_time = Examine(kTable + Cube("cube", 0.02), {}, Settled(1e9));
  CHECK(long_time.Codes() == Strings{"error physics/unstable"});
  CHECK(long_time.findings.begin()->hint == "use a time of at most 1e+07 steps");
}

TEST_CASE("on a free root, motions are those relative to the root") {
  const std::string tray = Free(0.5, R"(<geom type="box" size="0.2 0.2 0.01" pos="0 0 0"/>)");
  const std::string cube = R"(<body name="m_cube" pos="0 0 0.53"><freejoint/>)"
                           R"(<geom type="box" size="0.02 0.02 0.02"/></body>)";
  const Examined loaded = Examine(tray + cube, {}, Settled());
  CHECK(loaded.Codes().empty());
  CHECK(loaded.result->settled->bodies == 1);
}

}  // namespace
}  // namespace mjforge::physics
