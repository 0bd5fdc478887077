// Tests of --validate physics, validate --physics and check --physics.

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "harness/command.h"
#include "harness/effort.h"

namespace mjforge {
namespace {

using nlohmann::json;

constexpr const char* kLeaning =
    "mjforge: 1\n"
    "name: post\n"
    "params: {lean: 0 .. 60deg}\n"
    "checks: {stable: true, tilt: 5deg}\n"
    "parts: [{name: bar, type: box, size: [20mm, 20mm, 60mm], euler: [0, lean, 0]}]\n";

class PhysicsTest : public harness::ProgramTest {
 protected:
  std::vector<json> Records(const std::string& batch) const {
    std::vector<json> records;
    std::istringstream lines(folder().Read(batch + "/manifest.jsonl"));
    for (std::string line; std::getline(lines, line);) records.push_back(json::parse(line));
    return records;
  }
};

TEST_CASE_METHOD(PhysicsTest,
                 "what is measured stands in the manifest, and is the same whatever -j") {
  for (const std::string jobs : {"1", "2"}) {
    const auto result = Run({"generate", "robosuite/hinged_box", "-n", "6", "-j", jobs,
                             "--validate", "physics", "-o", "out" + jobs});
    INFO(result.err);
    REQUIRE(result.status == 0);
  }
  CHECK(folder().Read("out1/manifest.jsonl") == folder().Read("out2/manifest.jsonl"));
  for (const json& record : Records("out1")) {
    CHECK(record["validate"] == "physics");
    const json& physics = record["physics"];
    CHECK(physics["at_rest"] == true);
    CHECK(physics["ncon"] > 0);
    REQUIRE(physics["joints"].size() == 1);
    CHECK(physics["joints"][0]["reach"] > 0.9);
  }
  // The result of a variant does not depend on the range of variants that are made.
  REQUIRE(Run({"generate", "robosuite/hinged_box", "--first", "4", "--validate", "physics", "-o",
               "one"})
              .status == 0);
  CHECK(Records("one")[0]["physics"] == Records("out1")[4]["physics"]);
}

TEST_CASE_METHOD(PhysicsTest, "inspect says of a batch the sizes that a host needs") {
  REQUIRE(Run({"generate", "mug", "-n", "5", "--validate", "physics", "-o", "out"}).status == 0);
  int most = 0;
  for (const json& record : Records("out"))
    most = std::max(most, record["physics"]["nefc"].get<int>());
  const auto whole = Run({"inspect", "out/", "--json"});
  CHECK(json::parse(whole.out)["physics"]["nefc"]["max"] == most);
  CHECK(json::parse(whole.out)["physics"]["time"]["count"] == 5);
  CHECK(Run({"inspect", "out/"}).out.find("\n(nefc) ") != std::string::npos);
  REQUIRE(Run({"generate", "mug", "-o", "plain/"}).status == 0);
  CHECK(json::parse(Run({"inspect", "plain/", "--json"}).out)["physics"].empty());
}

TEST_CASE_METHOD(PhysicsTest, "the bytes of an object do not depend on what was asked about it") {
  REQUIRE(Run({"generate", "hammer", "-o", "a.xml"}).status == 0);
  REQUIRE(Run({"generate", "hammer", "--validate", "physics", "-o", "b.xml"}).status == 0);
  CHECK(folder().Read("a.xml") == folder().Read("b.xml"));
}

TEST_CASE_METHOD(PhysicsTest, "a variant that fails costs only itself, and replays") {
  folder().Write("post.yaml", kLeaning);
  const auto result =
      Run({"generate", "post.yaml", "-n", "20", "--validate", "physics", "-o", "out"});
  CHECK(result.status == 1);
  std::size_t failed = 0;
  std::string failure;
  for (const json& record : Records("out")) {
    const double tilt = record["physics"]["tilt"];
    const bool stands = tilt <= 5 * 3.14159265 / 180;
    CHECK(record["status"] == (stands ? "ok" : "failed"));
    if (stands) continue;
    ++failed;
    failure = std::to_string(record["index"].get<int>());
    CHECK(record["findings"][0]["code"] == "physics/topples");
  }
  REQUIRE(failed > 0);
  REQUIRE(failed < 20);
  const auto replay = Run({"replay", "out/manifest.jsonl:" + failure});
  CHECK(replay.status == 1);
  CHECK(replay.err.find("[physics/topples]") != std::string::npos);
  CHECK(replay.err.find("can be made") == std::string::npos);
}

TEST_CASE_METHOD(PhysicsTest,
                 "resampling draws until a variant behaves, and such a file replays alone") {
  folder().Write("post.yaml", kLeaning);
  const std::string count = std::to_string(harness::Effort(10, 4));
  REQUIRE(Run({"generate", "post.yaml", "-n", count, "--validate", "physics", "--on-invalid",
               "resample", "-o", "out"})
              .status == 0);
  bool drawn_again = false;
  for (const json& record : Records("out")) {
    CHECK(record["status"] == "ok");
    drawn_again |= record["attempt"] > 0;
    const auto replay = Run({"replay", "out/" + record["file"].get<std::string>()});
    INFO(replay.err);
    CHECK(replay.status == 0);
  }
  CHECK(drawn_again);
}

TEST_CASE_METHOD(PhysicsTest, "thresholds are set from outside, and recorded") {
  folder().Write("post.yaml", kLeaning);
  REQUIRE(
      Run({"generate", "post.yaml", "-n", "5", "--validate", "physics", "--set",
           "checks.tilt=180deg", "--set", "checks.silence={physics/drifts: why not}", "-o", "out"})
          .status == 0);
  CHECK(Records("out")[0]["set"]["checks.tilt"] == "180deg");
  const auto unknown = Run({"check", "post.yaml", "--physics", "--set", "checks.tlt=1"});
  CHECK(unknown.status == 1);
  CHECK(unknown.err.find("unknown key 'tlt' in checks") != std::string::npos);
  CHECK(unknown.err.find("did you mean 'tilt'?") != std::string::npos);
}

TEST_CASE_METHOD(PhysicsTest, "every target is tried as its host has it") {
  for (const std::string target : {"mujoco", "scene", "robosuite", "robocasa", "mjx"}) {
    CAPTURE(target);
    REQUIRE(Run({"generate", "robosuite/lid", "--target", target, "--validate", "physics", "-o",
                 target})
                .status == 0);
    const json physics = Records(target)[0]["physics"];
    CHECK(physics["dropped"] == true);
    CHECK(physics["at_rest"] == true);
  }
}

TEST_CASE_METHOD(PhysicsTest, "what a host frees may have its mass further in") {
  REQUIRE(Run({"generate", "robosuite/hinged_box", "--target", "robosuite", "--validate", "physics",
               "-o", "out"})
              .status == 0);
  CHECK(Records("out")[0]["physics"]["at_rest"] == true);
}

TEST_CASE_METHOD(PhysicsTest, "validate --physics tries any file, and says what came of it") {
  REQUIRE(Run({"generate", "robosuite/hinged_box", "-o", "box.xml"}).status == 0);
  const auto line = Run({"validate", "box.xml", "--physics"});
  CHECK(line.status == 0);
  CHECK(line.out.find("; at rest after 0.") != std::string::npos);
  CHECK(line.out.find("; 1 joint driven") != std::string::npos);
  const auto whole = Run({"validate", "box.xml", "--physics", "--json"});
  const json verdict = json::parse(whole.out);
  CHECK(verdict["physics"]["dropped"] == true);
  CHECK(verdict["findings"].empty());
  const auto strict =
      Run({"validate", "box.xml", "--physics", "--json", "--set", "checks.sink=1e-9"});
  CHECK(strict.status == 1);
  CHECK(json::parse(strict.out)["findings"][0]["code"] == "physics/sinks");
}

TEST_CASE_METHOD(PhysicsTest, "an included file and its meshes are found when a floor is put in") {
  folder().Write("parts/world.xml",
                 "<mujoco><worldbody><body name=\"b\" pos=\"0 0 1\"><freejoint/>"
                 "<geom size=\".1\"/></body></worldbody></mujoco>");
  folder().Write("top.xml", "<mujoco><include file=\"parts/world.xml\"/></mujoco>");
  const auto result = Run({"validate", "top.xml", "--physics"});
  INFO(result.err);
  CHECK(result.status == 0);
  CHECK(result.out.find("at rest after") != std::string::npos);
}

TEST_CASE_METHOD(PhysicsTest, "thresholds of a file are those of checks, and need --physics") {
  folder().Write("m.xml",
                 "<mujoco><worldbody><body><geom size=\".1\"/></body></worldbody></mujoco>");
  CHECK(Run({"validate", "m.xml", "--set", "checks.tilt=1deg"}).status == 2);
  const auto parameter = Run({"validate", "m.xml", "--physics", "--set", "size=1"});
  CHECK(parameter.status == 1);
  CHECK(parameter.err.find("'size' is not a threshold of a check") != std::string::npos);
}

TEST_CASE_METHOD(PhysicsTest, "every bundled object behaves") {
  const auto catalogue = Run({"catalogue", "--json"});
  REQUIRE(catalogue.status == 0);
  for (const json& item : json::parse(catalogue.out)) {
    const std::string name = item["name"];
    CAPTURE(name);
    if (name.starts_with("scenes/")) continue;  // takes seconds: `./dev physics`
    const auto result = Run({"check", name, "-n", "2", "--physics", "-q"});
    // The friction of the hammer's handle is robosuite's.
    if (name == "robosuite/hammer")
      CHECK(result.err.find("[physics/friction]") != std::string::npos);
    else
      CHECK(result.err.empty());
    CHECK(result.status == 0);
  }
}

}  // namespace
}  // namespace mjforge
