// Tests of `mjforge generate`: outputs, messages, exit status, interrupts.

#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "crate.h"

namespace mjforge {
namespace {

using Files = std::vector<std::string>;

// Replaces the seconds of a summary line, which vary.
std::string WithoutSeconds(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\(\d+\.\d s\))"), "(T s)");
}

TEST_CASE_METHOD(CrateTest, "without -o a batch goes into a folder of the object's name") {
  const auto result = Run({"generate", "crate.yaml", "-n", "2"});
  CHECK(result.status == 0);
  CHECK(result.out.empty());
  CHECK(WithoutSeconds(result.err) == "2 variants of crate in crate/: 2 ok (T s)\n");
  CHECK(folder().Files() == Files{"crate.yaml", "crate/crate_000000.xml", "crate/crate_000001.xml",
                                  "crate/manifest.jsonl", "crate/manifest.seal.json"});
}

TEST_CASE_METHOD(CrateTest, "with -o x.xml writes exactly that file") {
  const auto result = Run({"generate", "crate.yaml", "-o", "x.xml"});
  CHECK(result.status == 0);
  CHECK(WithoutSeconds(result.err) == "1 variant of crate in x.xml: 1 ok (T s)\n");
  CHECK(folder().Files() == Files{"crate.yaml", "x.xml"});
}

TEST_CASE_METHOD(CrateTest, "with -o - writes the object to standard output and says nothing") {
  const auto result = Run({"generate", "crate.yaml", "-o", "-"});
  CHECK(result.status == 0);
  CHECK(result.out.starts_with("<!--"));
  CHECK(result.out.ends_with("</mujoco>\n"));
  CHECK(result.err.empty());
  CHECK(folder().Files() == Files{"crate.yaml"});
}

TEST_CASE_METHOD(CrateTest, "a spec is read from standard input") {
  const auto result = Run({"generate", "-", "-o", "-"}, kText);
  CHECK(result.status == 0);
  CHECK(result.out.find("\"crate_body\"") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "a spec from standard input is kept beside the manifest for replay") {
  REQUIRE(Run({"generate", "-", "-n", "2", "-q", "-o", "out"}, kText).status == 0);
  CHECK(folder().Files() == Files{"crate.yaml", "out/crate_000000.xml", "out/crate_000001.xml",
                                  "out/manifest.jsonl", "out/manifest.seal.json",
                                  "out/manifest.spec.json"});
  const auto again = Run({"replay", "out/manifest.jsonl:1"});
  CHECK(again.status == 0);
  CHECK(Run({"replay", "out/crate_000000.xml"}).status == 0);
  std::filesystem::remove(folder() / "out/manifest.spec.json");
  CHECK(Run({"replay", "out/manifest.jsonl:1"}).status != 0);
}

TEST_CASE_METHOD(CrateTest, "several specs give one folder each") {
  folder().Write("ball.yaml",
                 "mjforge: 1\nname: ball\nparts: [{name: a, type: sphere, size: 1}]\n");
  REQUIRE(Run({"generate", "crate.yaml", "ball.yaml", "-q", "-o", "out"}).status == 0);
  CHECK(folder().Files() == Files{"ball.yaml", "crate.yaml", "out/ball/ball_000000.xml",
                                  "out/ball/manifest.jsonl", "out/ball/manifest.seal.json",
                                  "out/crate/crate_000000.xml", "out/crate/manifest.jsonl",
                                  "out/crate/manifest.seal.json"});
}

TEST_CASE_METHOD(CrateTest, "if one of several specs has a mistake nothing is written") {
  folder().Write("bad.yaml", "mjforge: 1\nname: bad\nparts: 3\n");
  CHECK(Run({"generate", "crate.yaml", "bad.yaml", "-o", "out"}).status == 1);
  CHECK_FALSE(std::filesystem::exists(folder() / "out"));
}

TEST_CASE_METHOD(CrateTest, "two specs of one name would share a folder") {
  folder().Write("other/crate.yaml", kText);
  const auto result = Run({"generate", "crate.yaml", "other/crate.yaml", "-o", "out"});
  CHECK(result.status == 1);
  CHECK(result.err ==
        "mjforge: error: two specs are named 'crate' and would share a folder "
        "[output/bad-name]\n"
        "  hint: generate them one by one\n");
  CHECK_FALSE(std::filesystem::exists(folder() / "out"));
}

TEST_CASE_METHOD(CrateTest, "the same command twice replaces its own files") {
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "3", "-o", "out"}).status == 0);
  const Files files = folder().Files();
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "3", "-o", "out"}).status == 0);
  CHECK(folder().Files() == files);
}

TEST_CASE_METHOD(CrateTest, "with --set pins and re-ranges a parameter, --params many") {
  folder().Write("p.yaml", "height: 0.5\n");
  const auto params = Run({"generate", "crate.yaml", "--params", "p.yaml", "-o", "-"});
  const auto set = Run({"generate", "crate.yaml", "--set", "height=0.5", "-o", "-"});
  CHECK(params.status == 0);
  CHECK(set.status == 0);
  CHECK(set.out.find("size=\"0.1 0.1 0.5\"") != std::string::npos);
  CHECK(params.out.find("size=\"0.1 0.1 0.5\"") != std::string::npos);
  const auto both =
      Run({"generate", "crate.yaml", "--params", "p.yaml", "--set", "height=20mm", "-o", "-"});
  CHECK(both.out.find("size=\"0.1 0.1 0.02\"") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "with --name renames the object and its files") {
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "2", "--name", "b${index}x"}).status == 0);
  CHECK(folder().Files() == Files{"crate.yaml", "crate/b0x_000000.xml", "crate/b1x_000001.xml",
                                  "crate/manifest.jsonl", "crate/manifest.seal.json"});
  CHECK(folder().Read("crate/b1x_000001.xml").find("\"b1x_body\"") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "with --name with characters that names cannot have is wrong usage") {
  for (const char* name : {"a b", "../up", "a/b", "a\"b", "a\nb", "1a"}) {
    const auto result = Run({"generate", "crate.yaml", "--name", name, "-o", "out"});
    CHECK(result.status == 2);
    CHECK(result.err.find("[output/bad-name]") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder() / "out"));
  }
}

TEST_CASE_METHOD(CrateTest, "with --target scene adds a floor") {
  const auto result = Run({"generate", "crate.yaml", "--target", "scene", "-o", "-"});
  CHECK(result.status == 0);
  CHECK(result.out.find("type=\"plane\"") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "with -v says a line about each variant") {
  const auto result = Run({"generate", "crate.yaml", "-v", "-n", "2", "-o", "out"});
  CHECK(WithoutSeconds(result.err) ==
        "out/crate_000000.xml: ok, attempt 0\n"
        "out/crate_000001.xml: ok, attempt 0\n"
        "2 variants of crate in out/: 2 ok (T s)\n");
}

TEST_CASE_METHOD(CrateTest, "an attached body keeps its inertia, however large") {
  folder().Write("arm.xml",
                 "<mujoco><worldbody><body name='arm'>\n"
                 "<inertial pos='0 0 0' quat='.8 0 0 .6' mass='1' diaginertia='3141592 2718281 "
                 "1618033'/>\n<geom size='.1'/></body></worldbody></mujoco>\n");
  folder().Write("thing.yaml",
                 "mjforge: 1\nname: thing\njoints: none\nbodies: [{name: a, mjcf: arm.xml}]\n");
  const auto result = Run({"generate", "thing.yaml", "-o", "-"});
  CHECK(result.err.empty());
  CHECK(
      result.out.find("quat=\"0.8 0 0 0.6\" mass=\"1\" diaginertia=\"3141592 2718281 1618033\"") !=
      std::string::npos);
}

TEST_CASE_METHOD(UnluckyCrateTest, "failed variants are reported and cost only themselves") {
  const auto result = Run({"generate", "crate.yaml", "-n", "20", "-o", "out"});
  CHECK(result.status == 1);
  CHECK(result.err.find("[model/bad-value]") != std::string::npos);
  CHECK(result.err.find("failed") != std::string::npos);
  CHECK(folder().Read("out/manifest.jsonl").find("\"status\":\"failed\"") != std::string::npos);
  CHECK(folder().Read("out/manifest.jsonl").find("\"status\":\"ok\"") != std::string::npos);
}

TEST_CASE_METHOD(UnluckyCrateTest, "with --on-invalid skip makes them warnings") {
  const auto result =
      Run({"generate", "crate.yaml", "-n", "20", "-o", "out", "--on-invalid", "skip"});
  CHECK(result.status == 0);
  CHECK(result.err.find(" error: ") == std::string::npos);
  CHECK(result.err.find(" warning: ") != std::string::npos);
  CHECK(folder().Read("out/manifest.jsonl").find("\"status\":\"skipped\"") != std::string::npos);
}

TEST_CASE_METHOD(UnluckyCrateTest, "with --on-invalid resample draws them again") {
  const auto result =
      Run({"generate", "crate.yaml", "-q", "-n", "20", "-o", "out", "--on-invalid", "resample"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(folder().Files().size() == 23);
}

TEST_CASE_METHOD(CrateTest, "a signal ends a program that waits for its spec") {
  // The script waits until mjforge sleeps, which means that it reads from the pipe.
  const harness::Command command{
      .program = "/bin/sh",
      .arguments = {"-c", "mkfifo pipe; sleep 50 > pipe & holder=$!; '" +
                              harness::MjforgeProgram().string() +
                              "' generate - -o out < pipe & "
                              "until grep -qx mjforge /proc/$!/comm && "
                              "grep -q '^State:.S' /proc/$!/status; do sleep 0.05; done; "
                              "kill -TERM $!; wait $!; status=$?; kill $holder; exit $status"},
      .folder = folder().path(),
      .timeout = std::chrono::seconds(40)};
  CHECK(command.Run().status == 143);
}

TEST_CASE_METHOD(CrateTest, "a signal that the caller ignores does not stop a batch") {
  // A shell without job control lets commands in the background ignore SIGINT.
  const harness::Command command{
      .program = "/bin/sh",
      .arguments = {"-c", "'" + harness::MjforgeProgram().string() +
                              "' generate crate.yaml -n 3000 -v -o out 2> words & "
                              "while ! grep -q crate_000002 words; do sleep 0.01; done; "
                              "kill -INT $!; wait $!"},
      .folder = folder().path()};
  CHECK(command.Run().status == 0);
  CHECK(folder().Read("words").find("3000 ok") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "an interrupted batch keeps what is done, with its records") {
  // The script interrupts the batch as soon as -v reports the third variant.
  const harness::Command command{
      .program = "/bin/sh",
      .arguments = {"-c", "'" + harness::MjforgeProgram().string() +
                              "' generate crate.yaml -n 1000000 -v -o out 2> words & "
                              "while ! grep -q crate_000002 words; do sleep 0.01; done; "
                              "kill -TERM $!; wait $!"},
      .folder = folder().path()};
  const auto result = command.Run();
  CHECK(result.status == 130);
  CHECK(folder().Read("words").find("interrupted") != std::string::npos);
  const std::string manifest = folder().Read("out/.manifest.jsonl.part");
  const auto lines = std::count(manifest.begin(), manifest.end(), '\n');
  CHECK(lines >= 3);
  // Workers can have written files that have no record yet.
  CHECK(folder().Files().size() >= static_cast<std::size_t>(lines) + 3);
}

}  // namespace
}  // namespace mjforge
