#include "mjforge/backport/sensor_references.h"

#include <string>

#include <catch2/catch.hpp>

#include "backported.h"

namespace mjforge::backport {
namespace {

TEST_CASE("a sensor that is left out must refer to elements of the file") {
  const auto found = [](const std::string& sensor) {
    return Backported(
               "<worldbody><body name=\"b\"><geom name=\"g\" "
               "size=\"1\"/></body></worldbody>\n<sensor>" +
               sensor + "</sensor>")
        .findings;
  };
  const std::string left_out =
      "3:9 warning: the distance on line 3 is left out: it only reads, and acts on nothing "
      "(MuJoCo 3.1.6)";
  CHECK(found("<distance geom1=\"g\" body2=\"world\"/>") == Strings{left_out});
  CHECK(
      found("<distance geom1=\"gg\" body2=\"a\"/>") ==
      Strings{"3:19 error: 'geom1' of the distance on line 3 is 'gg', but the file has no geom of "
              "that name",
              "3:30 error: 'body2' of the distance on line 3 is 'a', but the file has no body of "
              "that name",
              left_out});
  const std::string inside = "<insidesite objtype=\"xbody\" objname=\"b\" site=\"s\"/>";
  CHECK(found(inside).front() ==
        "3:49 error: 'site' of the insidesite on line 3 is 's', but the file has no site of that "
        "name");
}

TEST_CASE("an expansion makes names that a sensor may refer to") {
  const Backported file(
      "<worldbody>\n<replicate count=\"2\"><geom name=\"g\" size=\"1\"/></replicate></worldbody>\n"
      "<sensor><distance geom1=\"g0\" geom2=\"g1\"/></sensor>");
  CHECK(file.findings.size() == 2);
  CHECK(file.findings[0] == "3:1 error: the replicate on line 3 needs MuJoCo 3.1.5");
}

}  // namespace
}  // namespace mjforge::backport
