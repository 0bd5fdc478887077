// Tests of `mjforge validate`.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

constexpr const char* kGoodXml =
    "<mujoco>\n"
    "  <worldbody>\n"
    "    <body name=\"a\"><joint name=\"j\"/><geom size=\"0.1\" mass=\"2\"/></body>\n"
    "  </worldbody>\n"
    "</mujoco>\n";

constexpr const char* kBadXml =
    "<mujoco>\n"
    "  <worldbody>\n"
    "    <body name=\"a\"><geom size=\"0.1\" colour=\"red\"/></body>\n"
    "  </worldbody>\n"
    "</mujoco>\n";

TEST_CASE_METHOD(CrateTest, "validate says a line for each file") {
  folder().Write("a.xml", kGoodXml);
  folder().Write("b.xml", kGoodXml);
  const auto result = Run({"validate", "a.xml", "b.xml"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "a.xml: ok, 1 body, 1 joint, 1 geom, 2 kg\n"
        "b.xml: ok, 1 body, 1 joint, 1 geom, 2 kg\n");
}

TEST_CASE_METHOD(CrateTest, "a file that MuJoCo refuses is a finding at its line") {
  folder().Write("a.xml", kGoodXml);
  folder().Write("bad.xml", kBadXml);
  const auto result = Run({"validate", "bad.xml", "a.xml"});
  CHECK(result.status == 1);
  CHECK(result.err.starts_with("bad.xml:3"));
  CHECK(result.err.find("[mujoco/error]\n") != std::string::npos);
  CHECK(result.out == "bad.xml: failed\na.xml: ok, 1 body, 1 joint, 1 geom, 2 kg\n");
  CHECK(folder().Files() == std::vector<std::string>{"a.xml", "bad.xml", "crate.yaml"});
}

TEST_CASE_METHOD(CrateTest, "validate --json has the findings in it") {
  folder().Write("a.xml", kGoodXml);
  folder().Write("bad.xml", kBadXml);
  CHECK(Run({"validate", "a.xml", "--json"}).out ==
        "{\"file\":\"a.xml\",\"ok\":true,\"nbody\":2,\"njnt\":1,\"ngeom\":1,\"mass\":2,"
        "\"findings\":[]}\n");
  const auto result = Run({"validate", "bad.xml", "--json"});
  CHECK(result.status == 1);
  CHECK(result.err.empty());
  CHECK(result.out.starts_with("{\"file\":\"bad.xml\",\"ok\":false,\"findings\":[{\"severity\":"));
}

TEST_CASE_METHOD(CrateTest, "everything that generate writes is valid") {
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "3", "-o", "out"}).status == 0);
  CHECK(Run({"validate", "out/crate_000000.xml", "out/crate_000001.xml", "out/crate_000002.xml"})
            .status == 0);
}

TEST_CASE_METHOD(CrateTest, "validate --quiet says nothing but findings") {
  folder().Write("a.xml", kGoodXml);
  folder().Write("bad.xml", kBadXml);
  const auto result = Run({"validate", "-q", "a.xml", "bad.xml"});
  CHECK(result.status == 1);
  CHECK(result.out.empty());
  CHECK(result.err.starts_with("bad.xml:3"));
}

TEST_CASE_METHOD(CrateTest, "validate reads standard input, and what it refers to from here") {
  folder().Write("half.xml", "<mujoco><worldbody><geom size=\"1\"/></worldbody></mujoco>");
  const std::string good = std::string("\n") + kGoodXml;
  CHECK(Run({"validate", "-"}, good).out == "<stdin>: ok, 1 body, 1 joint, 1 geom, 2 kg\n");
  CHECK(Run({"validate", "-"}, "<mujoco><include file=\"half.xml\"/></mujoco>").out ==
        "<stdin>: ok, 0 bodies, 0 joints, 1 geom, 0 kg\n");
  const auto bad = Run({"validate", "-"}, kBadXml);
  CHECK(bad.status == 1);
  CHECK(bad.err.starts_with("<stdin>:3:"));
  CHECK(Run({"validate", "-", "--physics"}, kGoodXml).out.starts_with("<stdin>: ok, 1 body"));
  const std::string falling =
      "<mujoco><worldbody><body><freejoint/><geom type='box' size='.1 .1 .1' mass='1'/></body>"
      "</worldbody></mujoco>";
  const auto dropped = Run({"validate", "-", "--physics"}, falling);
  INFO(dropped.err);
  CHECK(dropped.out.find("; at rest after") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "inspect - takes MJCF or a spec, whichever standard input has") {
  CHECK(Run({"inspect", "-"}, kGoodXml).out.find("\na     world") != std::string::npos);
  CHECK(Run({"inspect", "-", "--sweep"}, kGoodXml).out.find("swept") != std::string::npos);
  // The object's text contains the name of its spec, so the line about the text differs.
  const std::string named = Run({"inspect", "crate.yaml"}).out;
  CHECK(Run({"inspect", "-"}, folder().Read("crate.yaml"))
            .out.starts_with(named.substr(0, named.find("\ntext "))));
  CHECK(Run({"inspect", "-"}, "").status == 1);
}

TEST_CASE_METHOD(CrateTest, "what is no MJCF is a finding") {
  CHECK(Run({"validate", "crate.yaml"}).status == 1);
  CHECK(Run({"validate", "none.xml"}).status != 0);
}

}  // namespace
}  // namespace mjforge
