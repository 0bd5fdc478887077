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

TEST_CASE_METHOD(CrateTest, "every command gives a file with meshes the same mass") {
  folder().Write("tray.obj",
                 "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                 "f 1 3 2\nf 1 4 3\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\n"
                 "f 4 5 8\n");
  folder().Write(
      "tray.xml",
      "<mujoco><asset><mesh name=\"t\" file=\"tray.obj\" scale=\"0.05 0.05 0.05\"/></asset>\n"
      "<worldbody><body name=\"tray\" pos=\"0 0 1\"><freejoint/>"
      "<geom type=\"mesh\" mesh=\"t\" density=\"500\"/></body></worldbody></mujoco>\n");
  folder().Write("shelf.yaml",
                 "mjforge: 1\nname: shelf\njoints: none\nbodies: [{name: tray, mjcf: tray.xml}]\n");
  const auto validated = Run({"validate", "tray.xml"});
  CHECK(validated.status == 0);
  CHECK(validated.out == "tray.xml: ok, 1 body, 1 joint, 1 geom, 0.200397 kg\n");
  CHECK(Run({"inspect", "tray.xml", "--sweep"}).out.find("\nmass     0.200397 kg\n") !=
        std::string::npos);
  CHECK(Run({"inspect", "shelf.yaml"}).out.find("\nmass     0.200397 kg\n") != std::string::npos);
  const auto simulated = Run({"validate", "--physics", "tray.xml"});
  CHECK(simulated.status == 0);
  CHECK(simulated.out.starts_with("tray.xml: ok, 1 body, 1 joint, 1 geom, 0.200397 kg; at rest"));
}

TEST_CASE_METHOD(CrateTest, "no command rejects many contacts") {
  folder().Write("bricks.yaml",
                 "mjforge: 1\nname: bricks\njoints: none\n"
                 "parts: [{name: floor, type: box, size: [5, 1, 5cm], pos: [0, 0, -5cm]}]\n"
                 "bodies:\n  - for: {i: 40}\n    name: brick_${i}\n    joints: free\n"
                 "    pos: [(i - 20) * 20cm, 0, 5cm]\n"
                 "    parts: [{name: \"b_${i}\", type: box, size: [5cm, 5cm, 5cm]}]\n");
  const auto generated = Run({"generate", "bricks.yaml", "-q", "-n", "1", "-o", "out"});
  CHECK(generated.status == 0);
  CHECK(generated.err.empty());
  CHECK(folder().Read("out/bricks_000000.xml").find("nconmax=\"160\"") != std::string::npos);
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"check", "bricks.yaml", "-q", "-n", "1", "--physics"},
        {"inspect", "bricks.yaml"},
        {"validate", "out/bricks_000000.xml"},
        {"validate", "--physics", "out/bricks_000000.xml"},
        {"inspect", "out/bricks_000000.xml"}}) {
    const auto result = Run(command);
    INFO(result.out);
    CHECK(result.status == 0);
    CHECK(result.err.empty());
  }
}

TEST_CASE_METHOD(CrateTest, "what is no MJCF is a finding") {
  CHECK(Run({"validate", "crate.yaml"}).status == 1);
  CHECK(Run({"validate", "none.xml"}).status != 0);
}

}  // namespace
}  // namespace mjforge
