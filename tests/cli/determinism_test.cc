// Tests that a variant is a pure function of (spec, seed, index).

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class DeterminismTest : public harness::ProgramTest {
 protected:
  // Fails the test unless the command succeeds.
  void Generate(std::vector<std::string> arguments,
                std::map<std::string, std::string> environment = {}) const {
    arguments.insert(arguments.begin(), {"generate", "-q", "--seed", "7"});
    const auto result = Run(std::move(arguments), {}, std::move(environment));
    INFO(result.err);
    REQUIRE(result.status == 0);
  }
  std::string Object(const std::string& out, const std::string& number) const {
    return folder().Read(out + "/hammer_" + number + ".xml");
  }
};

TEST_CASE_METHOD(DeterminismTest, "the same command gives the same bytes") {
  Generate({"hammer", "-n", "5", "-o", "a"});
  Generate({"hammer", "-n", "5", "-o", "deep/b"});
  CHECK(folder().Read("a/manifest.jsonl") == folder().Read("deep/b/manifest.jsonl"));
  for (const char* number : {"000000", "000001", "000002", "000003", "000004"}) {
    CHECK(Object("a", number) == Object("deep/b", number));
  }
  CHECK(Object("a", "000000") != Object("a", "000001"));
}

TEST_CASE_METHOD(DeterminismTest, "with --first 41 -n 1 is item 41 of -n 100") {
  Generate({"hammer", "-n", "100", "-o", "all"});
  Generate({"hammer", "-n", "1", "--first", "41", "-o", "one"});
  CHECK(Object("all", "000041") == Object("one", "000041"));
  CHECK(folder().Read("all/manifest.jsonl").find(folder().Read("one/manifest.jsonl")) !=
        std::string::npos);
}

TEST_CASE_METHOD(DeterminismTest, "another seed gives other bytes") {
  Generate({"hammer", "-o", "a.xml"});
  const auto result = Run({"generate", "hammer", "-q", "--seed", "8", "-o", "b.xml"});
  REQUIRE(result.status == 0);
  CHECK(folder().Read("a.xml") != folder().Read("b.xml"));
}

TEST_CASE_METHOD(DeterminismTest, "a file, a folder and standard output carry the same bytes") {
  Generate({"hammer", "--first", "3", "-o", "out"});
  Generate({"hammer", "--first", "3", "-o", "x.xml"});
  const auto result = Run({"generate", "hammer", "--seed", "7", "--first", "3", "-o", "-"});
  CHECK(result.out == folder().Read("x.xml"));
  CHECK(result.out == Object("out", "000003"));
}

TEST_CASE_METHOD(DeterminismTest, "German numbers change nothing") {
  const std::map<std::string, std::string> german = {{"LC_ALL", "de_DE.UTF-8"},
                                                     {"LANG", "de_DE.UTF-8"}};
  Generate({"hammer", "-n", "3", "-o", "a"});
  Generate({"hammer", "-n", "3", "-o", "b"}, german);
  CHECK(folder().Read("a/manifest.jsonl") == folder().Read("b/manifest.jsonl"));
  CHECK(Object("a", "000002") == Object("b", "000002"));
}

TEST_CASE_METHOD(CrateTest, "the spec's folder and how it is written change nothing") {
  folder().Write("else/where/crate.yaml", kText);
  const std::string absolute = (folder() / "crate.yaml").string();
  for (const std::string& spec : {std::string("crate.yaml"), std::string("./else/../crate.yaml"),
                                  absolute, std::string("else/where/crate.yaml")}) {
    const auto result = Run({"generate", spec, "-o", "-"});
    REQUIRE(result.status == 0);
    CHECK(result.out == Run({"generate", "crate.yaml", "-o", "-"}).out);
    CHECK(result.out.find(folder().path().string()) == std::string::npos);
  }
}

class SharedMeshTest : public DeterminismTest {
 protected:
  // Writes a mesh, and two specs with a part and an attached file that use it, in both orders.
  explicit SharedMeshTest(const std::string& more_of_mesh = {}) {
    folder().Write(
        "tetra.obj",
        "o a\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" +
            more_of_mesh);
    folder().Write(
        "a.xml",
        "<mujoco><asset><mesh name='t' file='tetra.obj'/></asset><worldbody><body name='b'>"
        "<geom type='mesh' mesh='t'/></body></worldbody></mujoco>");
    const std::string part =
        "  - {name: one, pos: [1, 0, 0], parts: [{name: p, type: mesh, file: tetra.obj}]}\n";
    const std::string attached = "  - {name: two, mjcf: a.xml}\n";
    const std::string head = "mjforge: 1\nname: s\njoints: none\nbodies:\n";
    folder().Write("part_first.yaml", head + part + attached);
    folder().Write("part_last.yaml", head + attached + part);
  }

  double MassOf(const std::string& out) const {
    return nlohmann::json::parse(folder().Read(out + "/manifest.jsonl")).at("mass");
  }
};

TEST_CASE_METHOD(SharedMeshTest,
                 "a part and an attached file share a mesh, however the spec is named") {
  for (const std::string name : {"part_first", "part_last"}) {
    INFO(name);
    Generate({name + ".yaml", "-o", name + "_a/"});
    Generate({(folder() / (name + ".yaml")).string(), "-o", name + "_b/"});
    CHECK(folder().Read(name + "_a/s_000000.xml") == folder().Read(name + "_b/s_000000.xml"));
    CHECK(folder().Read(name + "_a/assets/tetra.obj") == folder().Read("tetra.obj"));
    CHECK_FALSE(std::filesystem::exists(folder() / (name + "_a/assets/tetra_2.obj")));
  }
  CHECK(MassOf("part_first_a") == Approx(MassOf("part_last_a")));
}

/// The file has two shapes: MuJoCo reads the first one only, a part has both.
class MeshOfTwoShapesTest : public SharedMeshTest {
 protected:
  MeshOfTwoShapesTest()
      : SharedMeshTest(
            "o b\nv 1 0 0\nv 1.1 0 0\nv 1 0.1 0\nv 1 0 0.1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n") {
  }
};

TEST_CASE_METHOD(MeshOfTwoShapesTest, "a part has all shapes of a file that is attached, too") {
  Generate({"part_first.yaml", "-o", "first/"});
  Generate({"part_last.yaml", "-o", "last/"});
  Generate({(folder() / "part_last.yaml").string(), "-o", "absolute/"});
  const double tetra = 1000 * 0.001 / 6;  // kg
  CHECK(MassOf("first") == Approx(3 * tetra));
  CHECK(MassOf("last") == Approx(3 * tetra));
  CHECK(MassOf("absolute") == Approx(3 * tetra));
}

TEST_CASE_METHOD(DeterminismTest,
                 "names that an attached file gets do not depend on what else is attached") {
  folder().Write("arm.xml",
                 "<mujoco><worldbody><body name='b'><geom size='.1'/><body name='c' pos='0 0 1'>"
                 "<joint name='j'/><geom size='.1'/></body></body></worldbody>"
                 "<tendon><fixed><joint joint='j' coef='1'/></fixed></tendon><actuator>"
                 "<motor joint='j'/><motor joint='j'/><motor name='general1' joint='j'/></actuator>"
                 "<sensor><jointpos joint='j'/></sensor></mujoco>");
  const std::string head = "mjforge: 1\nname: s\njoints: none\nbodies:\n";
  const std::string right = "  - {name: right, pos: [3, 0, 0], mjcf: arm.xml}\n";
  folder().Write("one.yaml", head + right);
  folder().Write("two.yaml", head + "  - {name: left, mjcf: arm.xml}\n" + right);
  for (const char* spec : {"one.yaml", "two.yaml"}) {
    const auto result = Run({"generate", spec, "-o", "-"});
    REQUIRE(result.err.empty());
    for (const char* name : {"general0", "general1", "general1_", "fixed0", "jointpos0"}) {
      INFO(spec << ' ' << name);
      CHECK(result.out.find(std::string("name=\"s_right_") + name + "\"") != std::string::npos);
    }
  }
}

}  // namespace
}  // namespace mjforge
