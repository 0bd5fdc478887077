#include <string>

#include <catch2/catch.hpp>

#include "backported.h"

namespace mjforge::backport {
namespace {

/// A file with one actuator of joint `j` or body `b`, and a default class around it.
std::string Driven(const std::string& defaults, const std::string& actuator) {
  return "<default>" + defaults +
         "</default>\n<worldbody><body name=\"b\"><joint name=\"j\" type=\"slide\"/>"
         "<geom size=\"1\"/></body></worldbody>\n<actuator>" +
         actuator + "</actuator>";
}

TEST_CASE("a servo is damped by the bias of a default general, as in later releases") {
  struct Case {
    std::string defaults;
    std::string actuator;
    double gain;
    double damping;
  };
  const std::string general = "<general biastype=\"affine\" gainprm=\"30\" biasprm=\"0 -30 -4\"/>";
  const Case cases[] = {
      {general, "<position joint=\"j\"/>", 30, 4},
      {general, "<position joint=\"j\" kp=\"7\"/>", 7, 4},
      {general, "<intvelocity joint=\"j\" kp=\"7\" actrange=\"-1 1\"/>", 7, 4},
      {general, "<position joint=\"j\" kp=\"7\" kv=\"2\"/>", 7, 2},
      {general + "<default class=\"in\"><position kp=\"9\" kv=\"0\"/></default>",
       "<position class=\"in\" joint=\"j\"/>", 9, 0},
      {"<general biasprm=\"0 -30\"/>", "<position joint=\"j\"/>", 1, 0},
  };
  for (const auto& [defaults, actuator, gain, damping] : cases) {
    INFO(defaults << actuator);
    const Backported file(Driven(defaults, actuator));
    CHECK(file.findings.empty());
    engine::Loaded loaded;
    const mjModel& m = *Load(file.text, loaded);
    CHECK(m.actuator_gainprm[0] == gain);
    CHECK(m.actuator_biasprm[1] == -gain);
    CHECK(m.actuator_biasprm[2] == -damping);
  }
}

TEST_CASE("a servo whose gains are not plain numbers of servos keeps its words") {
  const std::string general = "<general biasprm=\"0 0 -2\"/>";
  for (const std::string other :
       {"<velocity kv=\"1\"/>", "<adhesion gain=\"1\" ctrlrange=\"0 1\"/>"}) {
    const Backported file(Driven(other + general, "<position joint=\"j\"/>"));
    REQUIRE(file.findings.size() == 1);
    CHECK(file.findings[0].find("warning: the position on line 4 has gains of the default") !=
          std::string::npos);
    CHECK(Backported(Driven(other + general, "<position joint=\"j\" kp=\"3\"/>"))
              .Says("biasprm=\"0 -3 -2 "));
  }
  const Backported ratio(Driven(general, "<position joint=\"j\" dampratio=\"1\"/>"));
  REQUIRE(ratio.findings.size() == 1);
  CHECK(ratio.findings[0].find("'dampratio' of the position") != std::string::npos);
}

TEST_CASE("an adhesion has the gain of its class, as in later releases") {
  const auto gain_of = [](const std::string& defaults, const std::string& more = "") {
    const Backported file(
        Driven(defaults, "<adhesion body=\"b\" ctrlrange=\"0 1\" " + more + "/>"));
    CHECK(file.findings.empty());
    engine::Loaded loaded;
    return Load(file.text, loaded)->actuator_gainprm[0];
  };
  const std::string adhesion = "<adhesion ctrlrange=\"0 1\" gain=\"25\"/>";
  CHECK(gain_of(adhesion) == 25);
  CHECK(gain_of(adhesion, "gain=\"3\"") == 3);
  CHECK(gain_of("<general gainprm=\"6\"/>") == 6);
  CHECK(gain_of("<motor gear=\"2\"/>") == 1);
}

TEST_CASE("a damper has the gain of its class, as in MuJoCo 4") {
  const auto gain_of = [](const std::string& more) {
    const Backported file(
        Driven("<damper kv=\"3\" ctrlrange=\"0 1\"/>", "<damper joint=\"j\" " + more + "/>"));
    CHECK(file.findings.empty());
    engine::Loaded loaded;
    return Load(file.text, loaded)->actuator_gainprm[2];
  };
  CHECK(gain_of("") == -3);
  CHECK(gain_of("kv=\"2\"") == -2);
}

TEST_CASE("gains of another kind of actuator are a warning, once for each two kinds") {
  const std::string said =
      "4:11 warning: the velocity on line 4 has gains of the default <position> up to MuJoCo 3.15, "
      "and not in later releases";
  const std::string defaults = "<position kp=\"800\"/>";
  CHECK(Backported(Driven(defaults, "<velocity joint=\"j\"/><velocity joint=\"j\"/>")).findings ==
        Strings{said});
  for (const std::string actuator :
       {"<velocity joint=\"j\" kv=\"2\"/>", "<position joint=\"j\"/>", "<motor joint=\"j\"/>"}) {
    CHECK(Backported(Driven(defaults, actuator)).findings.empty());
  }
  CHECK(Backported(Driven(defaults + "<velocity kv=\"3\"/>", "<velocity joint=\"j\"/>"))
            .findings.empty());
  CHECK(Backported(Driven(defaults, "<velocity joint=\"j\"/>"), 3016000).findings.empty());
}

}  // namespace
}  // namespace mjforge::backport
