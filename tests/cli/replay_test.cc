// Tests of `mjforge replay`.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class ReplayTest : public CrateTest {
 protected:
  ReplayTest() {
    REQUIRE(Run({"generate", "crate.yaml", "-q", "-n", "3", "-s", "7", "-o", "out"}).status == 0);
  }
};

TEST_CASE_METHOD(ReplayTest, "replay makes the same bytes again") {
  const auto record = Run({"replay", "out/manifest.jsonl:2"});
  CHECK(record.status == 0);
  CHECK(record.err == "out/manifest.jsonl:2: regenerated, same bytes\n");
  CHECK(Run({"replay", "out/crate_000001.xml"}).status == 0);
}

TEST_CASE_METHOD(ReplayTest, "replay takes an archive, and names the manifest of a series") {
  REQUIRE(Run({"generate", "crate.yaml", "-n", "4", "-q", "-o", "x.tar"}).status == 0);
  CHECK(Run({"replay", "x.tar:2"}).status == 0);
  REQUIRE(
      Run({"generate", "crate.yaml", "-n", "4", "-q", "--per-archive", "2", "-o", "s_%d.tar.zst"})
          .status == 0);
  CHECK(Run({"replay", "s_%d.tar.zst:3"}).status == 0);
  const auto member = Run({"replay", "s_1.tar.zst:3"});
  CHECK(member.status == 3);
  CHECK(
      member.err ==
      "mjforge: error: cannot read 's_1.tar.zst': it has no manifest of its own; name that of its "
      "series [yaml/cannot-read]\n");
}

TEST_CASE_METHOD(ReplayTest, "replay of a bundled spec works from any folder") {
  REQUIRE(Run({"generate", "hammer", "-q", "-o", "tools", "--set", "handle_length=0.2"}).status ==
          0);
  const std::string file = (folder() / "tools/hammer_000000.xml").string();
  const harness::TemporaryFolder elsewhere;
  const harness::Command command{.program = harness::MjforgeProgram(),
                                 .arguments = {"replay", file},
                                 .folder = elsewhere.path()};
  CHECK(command.Run().status == 0);
}

TEST_CASE_METHOD(ReplayTest,
                 "the option --root removes the free joint or adds one, and replay follows") {
  CHECK(Run({"generate", "hammer", "--root", "non", "-o", "-"}).err ==
        "mjforge: error: --root: 'non' is not one of free, none; did you mean 'none'?\n"
        "  hint: see 'mjforge generate --help'\n");
  REQUIRE(Run({"generate", "hammer", "-q", "--root", "none", "-o", "fixed"}).status == 0);
  CHECK(folder().Read("fixed/hammer_000000.xml").find("<joint") == std::string::npos);
  CHECK(Run({"replay", "fixed/manifest.jsonl:0"}).status == 0);
  CHECK(Run({"replay", "fixed/hammer_000000.xml"}).status == 0);
  REQUIRE(Run({"generate", "faucet", "-q", "--root", "free", "-o", "free"}).status == 0);
  CHECK(folder().Read("free/faucet_000000.xml").find("type=\"free\"") != std::string::npos);
  CHECK(Run({"replay", "free/faucet_000000.xml"}).status == 0);
}

TEST_CASE_METHOD(ReplayTest, "the option --start moves the start, and replay follows") {
  REQUIRE(Run({"generate", "laptop", "-q", "--start", "keyframe", "-o", "key"}).status == 0);
  CHECK(folder().Read("key/laptop_000000.xml").find(" ref=") == std::string::npos);
  CHECK(Run({"replay", "key/manifest.jsonl:0"}).status == 0);
  CHECK(Run({"replay", "key/laptop_000000.xml"}).status == 0);
  REQUIRE(Run({"generate", "laptop", "-q", "--start", "zero", "-o", "zero"}).status == 0);
  CHECK(folder().Read("zero/laptop_000000.xml").find(" ref=") != std::string::npos);
  CHECK(Run({"replay", "zero/manifest.jsonl:0"}).status == 0);
}

TEST_CASE_METHOD(ReplayTest, "a record leads back to its spec, wherever it stands") {
  folder().Write("specs/box.yaml", kText);
  folder().Write("deep/er/box.yaml", kText);
  const auto check = [&](const std::string& spec, const std::string& out,
                         const std::string& manifest) {
    INFO(spec << " " << out);
    REQUIRE(Run({"generate", spec, "-q", "-n", "3", "-o", out, "--force"}).status == 0);
    CHECK(folder().Read(manifest).find(folder().path().string()) == std::string::npos);
    CHECK(Run({"replay", manifest + ":2"}).err == manifest + ":2: regenerated, same bytes\n");
    const harness::TemporaryFolder elsewhere;
    const harness::Command command{.program = harness::MjforgeProgram(),
                                   .arguments = {"replay", (folder() / manifest).string() + ":1"},
                                   .folder = elsewhere.path()};
    CHECK(command.Run().status == 0);
  };
  check("specs/box.yaml", "a/", "a/manifest.jsonl");
  check("specs/box.yaml", "b/c", "b/c/manifest.jsonl");
  check((folder() / "specs/box.yaml").string(), (folder() / "d").string(), "d/manifest.jsonl");
  check("deep/er/box.yaml", "x.tar", "x.manifest.jsonl");
  check("deep/er/box.yaml", "deep/y_%d.tar.zst", "deep/y.manifest.jsonl.zst");
  CHECK(folder().Read("a/manifest.jsonl").find(R"("spec_file":"../specs/box.yaml")") !=
        std::string::npos);
  REQUIRE(Run({"generate", "specs/box.yaml", "hammer", "-q", "-o", "both"}).status == 0);
  CHECK(Run({"replay", "both/crate/manifest.jsonl:0"}).status == 0);
  CHECK(Run({"replay", "both/hammer/manifest.jsonl:0"}).status == 0);
  CHECK(folder().Read("both/hammer/manifest.jsonl").find("spec_file") == std::string::npos);
}

TEST_CASE_METHOD(ReplayTest, "a file leads to its spec through the manifest of its batch") {
  folder().Write("specs/box.yaml", kText);
  const auto check = [&](std::vector<std::string> options, const std::string& file) {
    options.insert(options.begin(), {"generate", "specs/box.yaml", "-q", "-n", "2"});
    REQUIRE(Run(options).status == 0);
    const auto here = Run({"replay", file});
    INFO(file << ": " << here.err);
    CHECK(here.err == file + ": regenerated, same bytes\n");
    const harness::TemporaryFolder elsewhere;
    const harness::Command command{.program = harness::MjforgeProgram(),
                                   .arguments = {"replay", (folder() / file).string()},
                                   .folder = elsewhere.path()};
    CHECK(command.Run().status == 0);
  };
  check({"-o", "far/away/batch"}, "far/away/batch/crate_000001.xml");
  check({"-o", "far/away/high", "--first", "10000"}, "far/away/high/0010000/crate_010001.xml");
  check({"-o", "far/away/part", "--shard", "1/2"}, "far/away/part/crate_000001.xml");
  std::filesystem::copy(folder() / "far/away/batch/crate_000001.xml", folder() / "alone.xml");
  CHECK(Run({"replay", "alone.xml"}).err ==
        "mjforge: error: cannot find the spec 'box.yaml' [yaml/cannot-read]\n"
        "  hint: pass its file with --spec\n");
}

TEST_CASE_METHOD(ReplayTest, "a folder stands for its manifest") {
  CHECK(Run({"replay", "out:2"}).err == "out:2: regenerated, same bytes\n");
  CHECK(Run({"replay", "out/:1"}).status == 0);
  CHECK(Run({"replay", ".:1"}).err.find("'./manifest.jsonl'") != std::string::npos);
}

TEST_CASE_METHOD(ReplayTest, "replay of a spec that is gone says how to name it") {
  std::filesystem::rename(folder() / "crate.yaml", folder() / "old.yaml");
  const auto result = Run({"replay", "out/manifest.jsonl:2"});
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot find the spec 'crate.yaml' [yaml/cannot-read]\n"
        "  hint: pass its file with --spec\n");
  CHECK(Run({"replay", "out/manifest.jsonl:2", "--spec", "old.yaml"}).status == 0);
}

TEST_CASE_METHOD(ReplayTest, "replay shows the first line that differs") {
  folder().Write("out/crate_000001.xml", folder().Read("out/crate_000001.xml") + "<!-- -->\n");
  const auto result = Run({"replay", "out/manifest.jsonl:1"});
  CHECK(result.status == 1);
  CHECK(result.err.find("[output/differs]\n<!-- -->\n^\n") != std::string::npos);
}

TEST_CASE_METHOD(ReplayTest, "replay notices a spec that changed since") {
  folder().Write("crate.yaml", std::string(kText) + "# more\n");
  const auto result = Run({"replay", "out/crate_000001.xml"});
  CHECK(result.status == 1);
  CHECK(result.err.find("spec 'crate.yaml' has changed since: its hash is ") != std::string::npos);
}

TEST_CASE_METHOD(ReplayTest, "replay of what it cannot understand is a finding") {
  const auto no_record = Run({"replay", "out/manifest.jsonl:9"});
  CHECK(no_record.status == 1);
  CHECK(no_record.err ==
        "mjforge: error: 'out/manifest.jsonl' has no record with index 9 "
        "[output/bad-manifest]\n");
  CHECK(Run({"replay", "crate.yaml"}).status == 1);
  CHECK(Run({"replay", "none.xml"}).status == 3);
}

}  // namespace
}  // namespace mjforge
