// Tests of outputs that cannot be written: exit status 3, the system's message, no partial files.

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "crate.h"
#include "harness/temporary_folder.h"

namespace mjforge {
namespace {

using Files = std::vector<std::string>;

class BadOutputTest : public CrateTest {
 protected:
  // Runs "mjforge generate crate.yaml" in a shell, with this text before and after the command.
  harness::CommandResult RunInShell(const std::string& before, const std::string& after) const {
    // A coverage build writes its counts to another folder, because the limits of these tests would
    // truncate them. Its error messages are discarded.
    const harness::TemporaryFolder profiles;
    const harness::Command command{
        .program = "/bin/sh",
        .arguments = {"-c", before + " '" + harness::MjforgeProgram().string() +
                                "' generate crate.yaml " + after},
        .environment = {{"GCOV_PREFIX", profiles.path().string()},
                        {"GCOV_ERROR_FILE", "/dev/null"}},
        .folder = folder().path()};
    auto result = command.Run();
    result.err = WithoutProfiling(result.err);
    return result;
  }

 private:
  // Removes messages of a coverage build that cannot write its counts.
  static std::string WithoutProfiling(const std::string& text) {
    std::string kept;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (line.find("profiling") == std::string::npos) kept += line + '\n';
    }
    return kept;
  }
};

TEST_CASE_METHOD(BadOutputTest, "an output folder that is a file is refused") {
  folder().Write("out", "text");
  const auto result = Run({"generate", "crate.yaml", "-q", "-o", "out"});
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot make folder 'out': Not a directory [output/cannot-write]\n");
  CHECK(folder().Files() == Files{"crate.yaml", "out"});
}

TEST_CASE_METHOD(BadOutputTest, "what killed processes left of a file is removed by the next run") {
  const auto [output, left] = GENERATE(
      table<std::string, Files>({{"out/",
                                  {"out/.crate_000000.xml.tmp1-0", "out/.manifest.seal.json.tmp1-0",
                                   "out/assets/.wood.png.tmp1-0"}},
                                 {"x.tar", {".x.manifest.seal.json.tmp1-0"}},
                                 {"x.xml", {".x.xml.tmp1-0", ".x.d.tmp1-0"}}}));
  INFO(output);
  const std::vector<std::string> arguments = {"generate", "crate.yaml", "-q", "-MD", "-o", output};
  REQUIRE(Run(arguments).status == 0);
  const Files whole = folder().Files();
  for (const std::string& file : left) folder().Write(file, "<mujoco");
  folder().Write(".crate.yaml.tmp1-0", "");
  CHECK(Run(arguments).status == 0);
  Files expected = whole;
  expected.insert(expected.begin(), ".crate.yaml.tmp1-0");
  CHECK(folder().Files() == expected);
  if (output != "out/") return;
  REQUIRE(Run({"report", "out/", "-q"}).status == 0);
  folder().Write("out/.report.html.tmp1-0", "");
  REQUIRE(Run({"report", "out/", "-q"}).status == 0);
  CHECK(folder().Files().size() == expected.size() + 1);
}

TEST_CASE_METHOD(BadOutputTest, "a file in a folder that cannot be made is refused") {
  const auto result = Run({"generate", "crate.yaml", "-q", "-o", "crate.yaml/x.xml"});
  CHECK(result.status == 3);
  CHECK(result.err.find("[output/cannot-write]") != std::string::npos);
}

TEST_CASE_METHOD(BadOutputTest, "a pipe is refused at once, by whoever writes a file") {
  REQUIRE(::mkfifo((folder().path() / "pipe.xml").c_str(), 0600) == 0);
  REQUIRE(::mkfifo((folder().path() / "pipe.png").c_str(), 0600) == 0);
  REQUIRE(Run({"generate", "crate.yaml", "-o", "out", "-q"}).status == 0);
  const std::vector<std::vector<std::string>> commands = {
      {"generate", "crate.yaml", "-o", "pipe.xml"},
      {"generate", "crate.yaml", "-o", "pipe.xml", "--force"},
      {"preview", "crate.yaml", "-o", "pipe.png"},
      {"report", "out", "-o", "pipe.xml"}};
  for (const std::vector<std::string>& command : commands) {
    CAPTURE(command);
    const auto result = Run(command);
    CHECK(result.status == 3);
    CHECK(result.err.find("is a pipe or a device, not a file") != std::string::npos);
  }
}

TEST_CASE_METHOD(BadOutputTest,
                 "a link in the place of a file is refused unless --force replaces it") {
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-o", "mine/"}).status == 0);
  REQUIRE(Run({"generate", "crate.yaml", "-q", "-o", "mine/x.tar"}).status == 0);
  const auto [output, link, target] = GENERATE(table<const char*, const char*, const char*>(
      {{"x.xml", "x.xml", "mine/crate_000000.xml"},
       {"out/", "out/crate_000000.xml", "mine/crate_000000.xml"},
       {"out/", "out/manifest.jsonl", "mine/manifest.jsonl"},
       {"out/", "out/manifest.seal.json", "mine/manifest.seal.json"},
       {"x.tar", "x.tar", "mine/x.tar"}}));
  INFO(link);
  std::filesystem::create_directory(folder() / "out");
  std::filesystem::create_symlink(folder() / target, folder() / link);
  const std::string kept = folder().Read(target);
  const auto result = Run({"generate", "crate.yaml", "-s", "2", "-o", output});
  CHECK(result.status == 3);
  CHECK(result.err.find(link + std::string("' is a link, not a file")) != std::string::npos);
  CHECK(std::filesystem::is_symlink(folder() / link));
  CHECK(Run({"generate", "crate.yaml", "-s", "2", "-o", output, "--force"}).status == 0);
  CHECK_FALSE(std::filesystem::is_symlink(folder() / link));
  CHECK(folder().Read(target) == kept);
}

TEST_CASE_METHOD(BadOutputTest, "a Make rule replaces a rule and nothing else") {
  folder().Write("notes.txt", "mine\n");
  for (const char* file : {"notes.txt", "x.xml", "crate.yaml", "/dev/full"}) {
    const std::string before = file[0] == '/' ? "" : folder().Read("crate.yaml");
    const auto result = Run({"generate", "crate.yaml", "-o", "x.xml", "-MD", "-MF", file, "-q"});
    INFO(file << ": " << result.err);
    CHECK(result.status == 3);
  }
  CHECK(std::filesystem::is_character_file("/dev/full"));
  CHECK(folder().Read("notes.txt") == "mine\n");
  CHECK(folder().Read("x.xml").starts_with("<!-- mjforge "));
  const std::vector<std::string> rule = {"generate", "crate.yaml", "-o",     "x.xml",
                                         "-MD",      "-MF",        "rule.d", "-q"};
  CHECK(Run(rule).status == 0);
  const std::string made = folder().Read("rule.d");
  CHECK(Run(rule).status == 0);
  CHECK(folder().Read("rule.d") == made);
}

TEST_CASE_METHOD(BadOutputTest, "the largest index is one that is made") {
  CHECK(Run({"generate", "crate.yaml", "--first", "18446744073709551615", "-o", "x.tar"}).status ==
        2);
  const auto result =
      Run({"generate", "crate.yaml", "--first", "18446744073709551613", "-n", "2", "-o", "x.tar"});
  INFO(result.err);
  CHECK(result.status == 0);
  CHECK(folder().Read("x.manifest.jsonl").find("\"index\":18446744073709551614,") !=
        std::string::npos);
}

TEST_CASE_METHOD(BadOutputTest, "a read-only folder is refused") {
  std::filesystem::create_directory(folder() / "out");
  std::filesystem::permissions(folder() / "out", std::filesystem::perms(0555));
  // Root can write anywhere, so the program runs as another user.
  const bool administrator = ::geteuid() == 0;
  if (administrator) std::filesystem::permissions(folder().path(), std::filesystem::perms(0755));
  const auto result = RunInShell(
      administrator ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "", "-q -o out");
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot write 'out/manifest.jsonl': Permission denied "
        "[output/cannot-write]\n");
  CHECK(folder().Files() == Files{"crate.yaml"});
}

// A limit on the size of files (1 means 512 bytes) has the effect of a full disk: writing fails
// halfway.
TEST_CASE_METHOD(BadOutputTest, "a file that does not fit leaves nothing") {
  const auto result = RunInShell("ulimit -f 1;", "-q -o crate.xml");
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot write 'crate.xml': File too large (seed 0, index 0) "
        "[output/cannot-write]\n");
  CHECK(folder().Files() == Files{"crate.yaml"});
}

TEST_CASE_METHOD(BadOutputTest, "a batch that does not fit leaves nothing") {
  const auto result = RunInShell("ulimit -f 1;", "-q -n 3 -o out");
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: cannot write 'out/crate_000000.xml': File too large (seed 0, index 0) "
        "[output/cannot-write]\n");
  CHECK_FALSE(std::filesystem::exists(folder() / "out"));
}

TEST_CASE_METHOD(BadOutputTest, "a full standard output is an output failure") {
  const auto result = RunInShell("", "-o - > /dev/full");
  CHECK(result.status == 3);
  CHECK(result.err == "mjforge: error: cannot write to standard output: No space left on device\n");
}

TEST_CASE_METHOD(BadOutputTest, "a standard output that nobody reads any more ends silently") {
  // The reader ends at once; the writer starts later and reports its status.
  const auto result = RunInShell("{ sleep 0.2;", "-o -; echo $? > status; } | true");
  CHECK(folder().Read("status") == "141\n");
  CHECK(result.err.empty());
}

TEST_CASE_METHOD(BadOutputTest, "somebody else's file is only overwritten with --force") {
  folder().Write("x.xml", "<mujoco/>\n");
  const auto refused = Run({"generate", "crate.yaml", "-q", "-o", "x.xml"});
  CHECK(refused.status == 3);
  CHECK(refused.err ==
        "mjforge: error: 'x.xml' exists and was not made by mjforge (seed 0, index 0) "
        "[output/exists]\n"
        "  hint: choose another place, or overwrite it with --force\n");
  CHECK(folder().Read("x.xml") == "<mujoco/>\n");
  CHECK(Run({"generate", "crate.yaml", "-q", "-o", "x.xml", "--force"}).status == 0);
  CHECK(folder().Read("x.xml") != "<mujoco/>\n");
  // The file now has the mark of mjforge.
  CHECK(Run({"generate", "crate.yaml", "-q", "-o", "x.xml"}).status == 0);
}

TEST_CASE_METHOD(BadOutputTest, "a folder with somebody else's manifest is refused") {
  folder().Write("out/manifest.jsonl", "{\"image\": 1}\n");
  const auto result = Run({"generate", "crate.yaml", "-q", "-o", "out"});
  CHECK(result.status == 3);
  CHECK(result.err ==
        "mjforge: error: 'out/manifest.jsonl' exists and was not made by mjforge "
        "[output/exists]\n"
        "  hint: choose another place, or overwrite it with --force\n");
  CHECK(folder().Files() == Files{"crate.yaml", "out/manifest.jsonl"});
}

}  // namespace
}  // namespace mjforge
