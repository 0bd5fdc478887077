// Tests of streams: results on standard output, messages on standard error, color on request.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class WordsTest : public CrateTest {
 protected:
  WordsTest() {
    folder().Write("bad.yaml", "mjforge: 1\nname: bad\nparts:\n  - {name: a, type: bux}\n");
  }
};

TEST_CASE_METHOD(WordsTest, "findings go to standard error and results to standard output") {
  const auto bad = Run({"generate", "bad.yaml", "-o", "-"});
  CHECK(bad.status == 1);
  CHECK(bad.out.empty());
  CHECK(bad.err.starts_with("bad.yaml:4:"));
  const auto good = Run({"inspect", "crate.yaml"});
  CHECK(good.err.empty());
  CHECK_FALSE(good.out.empty());
}

TEST_CASE_METHOD(WordsTest, "with -q leaves only errors") {
  CHECK(Run({"generate", "crate.yaml", "-q"}).err.empty());
  CHECK(Run({"check", "crate.yaml", "-q"}).err.empty());
  CHECK_FALSE(Run({"check", "bad.yaml", "-q"}).err.empty());
}

TEST_CASE_METHOD(WordsTest, "color comes only when it is asked for, or on a terminal") {
  const auto has_color = [](const harness::CommandResult& result) {
    return result.err.find('\x1b') != std::string::npos;
  };
  CHECK_FALSE(has_color(Run({"check", "bad.yaml"})));
  CHECK_FALSE(has_color(Run({"check", "bad.yaml", "--color", "never"})));
  CHECK(has_color(Run({"check", "bad.yaml", "--color", "always"})));
}

TEST_CASE_METHOD(WordsTest, "NO_COLOR is heard on a terminal") {
  // script(1) runs a command on a new terminal.
  const auto on_terminal = [&](const std::string& before) {
    const harness::Command command{
        .program = "script",
        .arguments = {"-qec",
                      before + " '" + harness::MjforgeProgram().string() + "' check bad.yaml",
                      "/dev/null"},
        .environment = {{"TERM", "xterm"}},
        .folder = folder().path()};
    const auto result = command.Run();
    CHECK(result.out.find("bad.yaml:4:") != std::string::npos);
    return result.out.find("\x1b[") != std::string::npos;
  };
  CHECK(on_terminal(""));
  CHECK_FALSE(on_terminal("NO_COLOR=1"));
  CHECK_FALSE(on_terminal("TERM=dumb"));
}

TEST_CASE_METHOD(WordsTest, "with --findings json gives one object a line") {
  const auto result = Run({"check", "bad.yaml", "--findings", "json"});
  CHECK(result.status == 1);
  CHECK(result.err.starts_with("{\"severity\":\"error\",\"code\":\"spec/"));
  CHECK(result.err.ends_with("}\n"));
}

TEST_CASE_METHOD(WordsTest, "check says how many variants are fine, and writes nothing") {
  const auto result = Run({"check", "crate.yaml"});
  CHECK(result.status == 0);
  CHECK(result.out.empty());
  CHECK(result.err ==
        "crate.yaml: 20 of 20 variants ok\n"
        "  up to 14 % of all variants may still fail (with 95 % confidence); -n 300 lowers that to "
        "1 %\n");
  CHECK(folder().Files() == std::vector<std::string>{"bad.yaml", "crate.yaml"});
}

TEST_CASE_METHOD(WordsTest,
                 "check says no share of variants if there is one, or if all are alike") {
  CHECK(Run({"check", "crate.yaml", "-n", "1"}).err == "crate.yaml: 1 of 1 variants ok\n");
  CHECK(Run({"check", "crate.yaml", "--set", "height=0.1"}).err ==
        "crate.yaml: 20 of 20 variants ok\n");
  CHECK(Run({"check", "crate.yaml", "-q"}).err.empty());
}

TEST_CASE_METHOD(UnluckyCrateTest, "check finds what only some variants show") {
  const auto result = Run({"check", "crate.yaml"});
  CHECK(result.status == 1);
  CHECK(result.err.find("[model/bad-value]\n") != std::string::npos);
  CHECK(result.err.find(" variants have this finding; this is the first\n") != std::string::npos);
}

}  // namespace
}  // namespace mjforge
