#include "mjforge/backport/refused_attributes.h"

#include <string>

#include <catch2/catch.hpp>

#include "backported.h"

namespace mjforge::backport {
namespace {

TEST_CASE("attributes that later releases reject are a warning") {
  const Backported file(
      "<option apirate=\"50\" iterations=\"1.5\"><flag passive=\"disable\"/></option>\n"
      "<visual><map znear=\"0\"/><headlight active=\"7\"/></visual><size nconmax=\"-3\"/>");
  CHECK(file.findings ==
        Strings{"2:9 warning: the option on line 2 has 'apirate', which MuJoCo 3.3.7 and later "
                "reject",
                "2:22 warning: the option on line 2 has 'iterations=1.5'; MuJoCo 3.0.0 and "
                "later require an integer",
                "2:45 warning: the flag on line 2 has 'passive', which MuJoCo 3.3.6 and later "
                "reject",
                "3:14 warning: the map on line 3 has 'znear=0'; MuJoCo 2.3.0 and later "
                "require a number above 0",
                "3:36 warning: the headlight on line 3 has 'active=7'; MuJoCo 4.0.0 and "
                "later require 0 or 1",
                "3:63 warning: the size on line 3 has 'nconmax=-3'; MuJoCo 2.3.0 and later "
                "require an integer of at least -1"});
  CHECK_FALSE(file.changed);
  CHECK(Backported("<option apirate=\"50\"/>", kPortable, Use::kBodies).findings.empty());
  CHECK(Backported("<option apirate=\"50\"/>", 337).findings.empty());
  CHECK(Backported("<option iterations=\"20\"/><size njmax=\"-1\"/><statistic extent=\"2\"/>")
            .findings.empty());
}

TEST_CASE("quaternions of zeros, and two forms of an inertia, are a warning") {
  const Backported file(
      "<worldbody>\n<body quat=\"0 0 0 0\"><inertial mass=\"1\" pos=\"0 0 0\" "
      "diaginertia=\"1 1 1\" fullinertia=\"1 1 1 0 0 0\"/>\n<geom size=\"1\" "
      "quat=\"0 0 0 1\"/></body></worldbody>");
  CHECK(file.findings ==
        Strings{"3:7 warning: the body on line 3 has 'quat=0 0 0 0'; MuJoCo 3.0.0 and later "
                "require a quaternion other than zero",
                "3:53 warning: the inertial on line 3 has 'diaginertia' beside 'fullinertia'; "
                "MuJoCo 3.2.4 and later reject this"});
}

TEST_CASE("another name of the default class than main is a warning") {
  CHECK(Backported("<default class=\"own\"><default class=\"inner\"/></default>").findings ==
        Strings{"2:10 warning: the default on line 2 has 'class=own'; MuJoCo 3.2.0 and later "
                "require the name 'main'"});
  CHECK(
      Backported("<default class=\"main\"><default class=\"inner\"/></default>").findings.empty());
}

TEST_CASE("composites that later releases lack are a warning") {
  const std::pair<const char*, const char*> types[] = {
      {"rope", "3.0.0"},      {"cloth", "3.0.0"}, {"box", "3.2.5"},      {"cylinder", "3.2.5"},
      {"ellipsoid", "3.2.5"}, {"loop", "3.2.6"},  {"particle", "3.3.0"}, {"grid", "3.3.0"}};
  for (const auto& [type, since] : types) {
    const Backported file(std::string("<worldbody>\n<composite type=\"") + type +
                          "\" count=\"3 3 3\" spacing=\".1\"/></worldbody>");
    CHECK(file.findings == Strings{std::string("3:12 warning: the composite on line 3 has 'type=") +
                                   type + "', which MuJoCo " + since + " and later reject"});
  }
}

}  // namespace
}  // namespace mjforge::backport
