#include "mjforge/engine/replicas.h"

#include <cmath>
#include <cstddef>
#include <string>

#include <catch2/catch.hpp>

#include "adapted.h"

namespace mjforge::engine {
namespace {

/// The names of all elements of a kind, as MuJoCo 2.2 has them; unnamed ones are empty.
Strings Names(const mjModel& m, mjtObj kind, int count) {
  Strings names;
  for (int i = 0; i < count; ++i) {
    const char* name = mj_id2name(&m, kind, i);
    names.emplace_back(name == nullptr ? "" : name);
  }
  return names;
}

const std::string kBall = "<geom name=\"g\" size=\"0.1\"/>";
const std::string kJointed =
    "<body name=\"a\"><joint name=\"j\"/>" + kBall + "<site name=\"s\"/></body>";
const std::string kFixed =
    "<body name=\"o\"><joint name=\"jo\"/><geom name=\"go\" size=\"1\"/></body>";

TEST_CASE("copies are moved by the offset, turned by the angles, and numbered") {
  const Adapted file(
      "<worldbody>\n<replicate count=\"4\" offset=\"1 0 0\" euler=\"0 0 90\" sep=\"-\">" + kBall +
      "</replicate></worldbody>");
  CHECK(file.findings.empty());
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(Names(m, mjOBJ_GEOM, m.ngeom) == Strings{"g-0", "g-1", "g-2", "g-3"});
  const double meant[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (std::ptrdiff_t i = 0; i < 4; ++i) {
    CHECK(m.geom_pos[3 * i] == Approx(meant[i][0]).margin(1e-12));
    CHECK(m.geom_pos[3 * i + 1] == Approx(meant[i][1]).margin(1e-12));
    CHECK(m.geom_quat[4 * i] == Approx(std::cos(static_cast<double>(i) * mjPI / 4)).margin(1e-12));
  }
}

TEST_CASE("numbers have as many digits as the count") {
  const Adapted file("<worldbody><replicate count=\"10\">" + kBall + "</replicate></worldbody>");
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(Names(m, mjOBJ_GEOM, m.ngeom).front() == "g00");
  CHECK(Names(m, mjOBJ_GEOM, m.ngeom).back() == "g09");
  for (const std::string none : {"0", "-1", "-inf"}) {
    CHECK(Adapted("<worldbody><replicate count=\"" + none + "\">" + kBall +
                  "</replicate></worldbody>")
              .text == "<mujoco>\n<worldbody></worldbody></mujoco>");
  }
}

// As in MuJoCo's documentation of the element.
TEST_CASE("what is replicated twice has the inner number first, and so does what refers to it") {
  const Adapted file(
      "<worldbody><replicate count=\"2\" offset=\"0 1 0\" euler=\"90 0 0\">"
      "<replicate count=\"2\" sep=\"-\" offset=\"1 0 0\" euler=\"0 90 0\">"
      "<site name=\"Alice\" size=\".1\"/></replicate></replicate></worldbody>"
      "<sensor><accelerometer name=\"Bob\" site=\"Alice\"/></sensor>");
  CHECK(file.findings.empty());
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(Names(m, mjOBJ_SITE, m.nsite) == Strings{"Alice-00", "Alice-10", "Alice-01", "Alice-11"});
  CHECK(Names(m, mjOBJ_SENSOR, m.nsensor) == Strings{"Bob-00", "Bob-10", "Bob-01", "Bob-11"});
  CHECK(m.sensor_objid[3] == 3);
  CHECK(m.site_pos[9] == Approx(1));
  CHECK(m.site_pos[10] == Approx(1));
  for (std::ptrdiff_t i = 12; i < 16; ++i) CHECK(m.site_quat[i] == Approx(0.5));
}

// The names and their order are those of MuJoCo 4.0.
TEST_CASE(
    "what refers to replicas is there for each; contacts, tendons and sensors may join others") {
  const Adapted file(
      "<worldbody>" + kFixed + "<replicate count=\"2\" offset=\"1 0 0\">" + kJointed +
      "</replicate></worldbody>"
      "<contact><exclude name=\"e\" body1=\"a\" body2=\"o\"/><pair name=\"p\" geom1=\"go\" "
      "geom2=\"g\"/>"
      "</contact>"
      "<equality><weld name=\"x\" body1=\"a\"/></equality>"
      "<sensor><framepos name=\"s1\" objtype=\"body\" objname=\"a\" reftype=\"xbody\" "
      "refname=\"o\"/>"
      "<framepos name=\"s2\" objtype=\"body\" objname=\"o\" reftype=\"body\" refname=\"a\"/>"
      "<actuatorfrc name=\"s3\" actuator=\"m\"/><clock name=\"c\"/></sensor>"
      "<actuator><motor name=\"mo\" joint=\"jo\"/><motor name=\"m\" joint=\"j\"/></actuator>"
      "<actuator><motor name=\"mt\" tendon=\"t\"/><motor name=\"mo2\" joint=\"jo\"/></actuator>"
      "<tendon><fixed name=\"t\"><joint joint=\"j\" coef=\"1\"/><joint joint=\"jo\" "
      "coef=\"1\"/></fixed>"
      "<spatial name=\"u\"><site site=\"s\"/><geom geom=\"g\" sidesite=\"s\"/><site "
      "site=\"s\"/></spatial>"
      "</tendon>"
      "<custom><tuple name=\"k\"><element objtype=\"body\" objname=\"a\"/></tuple></custom>");
  CHECK(file.findings.empty());
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(Names(m, mjOBJ_EXCLUDE, m.nexclude) == Strings{"e0", "e1"});
  CHECK(Names(m, mjOBJ_PAIR, m.npair) == Strings{"p0", "p1"});
  CHECK(Names(m, mjOBJ_EQUALITY, m.neq) == Strings{"x0", "x1"});
  CHECK(Names(m, mjOBJ_SENSOR, m.nsensor) ==
        Strings{"c", "s10", "s20", "s30", "s11", "s21", "s31"});
  CHECK(Names(m, mjOBJ_ACTUATOR, m.nu) == Strings{"mo", "mo2", "m0", "mt0", "m1", "mt1"});
  CHECK(Names(m, mjOBJ_TENDON, m.ntendon) == Strings{"t0", "u0", "t1", "u1"});
  CHECK(Names(m, mjOBJ_TUPLE, m.ntuple) == Strings{"k0", "k1"});
  CHECK(m.pair_geom2[0] == m.pair_geom2[1] - 1);
  CHECK(m.actuator_trnid[2 * 5] == 2);
}

TEST_CASE("what cannot join replicas with something else is left out with a warning") {
  const Adapted file(
      "<worldbody><replicate count=\"2\" offset=\"1 0 0\">" + kJointed + "</replicate>" + kFixed +
      "</worldbody>\n<equality>\n<joint name=\"J\" joint1=\"j\" joint2=\"jo\"/></equality>");
  CHECK(file.findings ==
        Strings{"4:1 warning: joint 'J' is left out, as in MuJoCo 3.1.5: it joins what is "
                "replicated with something else"});
  Loaded loaded;
  CHECK(Load(file.text, loaded)->neq == 0);
}

TEST_CASE("a camera looks at the copy beside it") {
  const Adapted file("<worldbody><replicate count=\"2\"><camera name=\"c\" target=\"a\"/>" +
                     kJointed + "</replicate></worldbody>");
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.cam_targetbodyid[0] == 1);
  CHECK(m.cam_targetbodyid[1] == 2);
}

TEST_CASE("a replicate's class is that of what it copies") {
  const Adapted file(
      "<default><default class=\"k\"><geom size=\"3\"/></default></default><worldbody>"
      "<frame pos=\"0 0 1\"><replicate count=\"2\" childclass=\"k\"><geom/></replicate></frame>"
      "</worldbody>");
  Loaded loaded;
  const mjModel& m = *Load(file.text, loaded);
  CHECK(m.geom_size[3] == 3);
  CHECK(m.geom_pos[5] == 1);
}

TEST_CASE("what MuJoCo refuses in a replicate is an error at its place") {
  const auto findings = [](const std::string& words, const std::string& inside = "") {
    return Adapted("<worldbody>\n<replicate " + words + ">\n" + inside + "</replicate></worldbody>")
        .findings;
  };
  CHECK(findings("offset=\"1 0 0\"") ==
        Strings{"3:1 error: 'count' of the replicate on line 3 is missing"});
  CHECK(findings("count=\"2.5\"") ==
        Strings{"3:12 error: 'count' of the replicate on line 3 must be a whole number"});
  CHECK(findings("count=\"two\"") ==
        Strings{"3:12 error: 'count' of the replicate on line 3 must be 1 number"});
  CHECK(findings("count=\"2\" offset=\"1 2\"") ==
        Strings{"3:22 error: 'offset' of the replicate on line 3 must be 3 numbers"});
  CHECK(
      findings("count=\"2\"", "<frame><joint name=\"j\"/></frame>") ==
      Strings{"4:8 error: joint 'j' stands in a replicate, but not in a body that is replicated"});
  CHECK(findings("count=\"3\"", "<geom size=\"1\" pos=\"0\"/>") ==
        Strings{"4:16 error: 'pos' of the geom on line 4 must be 3 numbers"});
  CHECK(findings("count=\"2\"",
                 "<body><composite type=\"grid\" count=\"2 1 1\" spacing=\"1\"/></body>")
            .front() == "4:7 error: the composite on line 4 needs MuJoCo 3.3.1");
}

TEST_CASE("not more than a hundred thousand elements are written out") {
  const auto findings = [](const std::string& inside) {
    return Adapted("<worldbody>\n" + inside + "</worldbody>").findings;
  };
  CHECK(findings("<replicate count=\"1000000000\">" + kBall + "</replicate>") ==
        Strings{"3:12 error: 'count' of the replicate on line 3 makes more than 100000 elements"});
  CHECK(findings("<replicate count=\"inf\"/>").size() == 1);
  CHECK(findings("<replicate count=\"nan\"/>").size() == 1);
  std::string nested = kBall;
  for (int i = 0; i < 8; ++i) nested = "<replicate count=\"9\">" + nested + "</replicate>";
  CHECK(findings(nested).size() == 1);
}

}  // namespace
}  // namespace mjforge::engine
