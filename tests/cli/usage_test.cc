// Tests of wrong usage: exit status 2 and two lines of message.

#include <algorithm>
#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

class UsageTest : public CrateTest {
 protected:
  std::string WrongUsage(std::vector<std::string> arguments) const {
    const auto result = Run(std::move(arguments));
    CHECK(result.status == 2);
    CHECK(result.out.empty());
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 2);
    CHECK_FALSE(std::filesystem::exists(folder() / "crate"));
    return result.err.substr(0, result.err.find('\n'));
  }
};

TEST_CASE_METHOD(UsageTest, "unknown words are named, with what was probably meant") {
  CHECK(WrongUsage({}) == "mjforge: error: a command is missing");
  CHECK(WrongUsage({"genrate", "crate.yaml"}) ==
        "mjforge: error: there is no command 'genrate'; did you mean 'generate'?");
  CHECK(WrongUsage({"--sed"}) == "mjforge: error: there is no option '--sed'");
  CHECK(WrongUsage({"generate", "crate.yaml", "--sed", "3"}) ==
        "mjforge: error: there is no option '--sed'; did you mean '--seed'?");
  CHECK(WrongUsage({"schema", "object", "more"}) == "mjforge: error: 'more' is one word too many");
  CHECK(WrongUsage({"schema", "object", "--", "more"}) ==
        "mjforge: error: 'more' is one word too many");
  CHECK(WrongUsage({"replay", "--"}) == "mjforge: error: WHAT is required");
}

TEST_CASE_METHOD(UsageTest, "values that an option cannot take are wrong usage") {
  const std::vector<std::vector<std::string>> wrong = {
      {"-n", "0"},
      {"-n", "-1"},
      {"-n", "many"},
      {"-n", "1e3"},
      {"--seed", "-1"},
      {"--seed", "18446744073709551616"},
      {"--target", "mars"},
      {"--validate", "no"},
      {"--on-invalid", "cry"},
      {"--set", "height"},
      {"--set", "=3"},
      {"--color", "blue"},
      {"--findings", "xml"},
      {"-n", "2", "-o", "x.xml"},
      {"-n", "2", "-o", "-"},
      {"-o", "x.zip"},
      {"--first", "18446744073709551615", "-n", "2"},
      {"other.yaml", "-o", "x.xml"},
      {"-o"}};
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), {"generate", "crate.yaml"});
    INFO(arguments[2] << " " << arguments.back());
    CHECK(WrongUsage(arguments).starts_with("mjforge: error: "));
  }
  CHECK(WrongUsage({"generate"}).starts_with("mjforge: error: "));
  CHECK(WrongUsage({"generate", "crate.yaml", "--target", "secne"}) ==
        "mjforge: error: --target: 'secne' is not one of mujoco, scene, robosuite, robocasa, mjx; "
        "did you mean 'scene'?");
}

TEST_CASE_METHOD(UsageTest, "an option that is repeated is said to be") {
  CHECK(WrongUsage({"generate", "crate.yaml", "-n", "1", "-n", "2"}) ==
        "mjforge: error: --count is given 2 times");
}

TEST_CASE_METHOD(UsageTest, "a folder is no file to write, and a missing folder is one finding") {
  std::filesystem::create_directory(folder() / "z.xml");
  CHECK(Run({"generate", "crate.yaml", "-o", "z.xml", "--force"})
            .err.starts_with("mjforge: error: 'z.xml' is a folder, not a file (seed 0, index 0) "
                             "[output/cannot-write]\n  hint: choose another name\n"));
  CHECK(Run({"verify", "nothere/"}).err ==
        "mjforge: error: cannot read 'nothere': No such file or directory [yaml/cannot-read]\n");
}

TEST_CASE_METHOD(UsageTest, "a number with a leading zero is decimal") {
  CHECK(Run({"generate", "crate.yaml", "--seed", "010", "-o", "-"}).out ==
        Run({"generate", "crate.yaml", "--seed", "10", "-o", "-"}).out);
}

TEST_CASE_METHOD(UsageTest, "the help of every command fits a screen and has examples") {
  for (const char* name :
       {"generate", "check", "inspect", "validate", "replay", "catalogue", "schema"}) {
    const auto result = Run({name, "--help"});
    INFO(result.out);
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    CHECK(std::count(result.out.begin(), result.out.end(), '\n') <= 50);
    CHECK(result.out.find("\nExamples:\n  ") != std::string::npos);
    std::size_t begin = 0;
    while (begin < result.out.size()) {
      const std::size_t end = result.out.find('\n', begin);
      INFO(result.out.substr(begin, end - begin));
      CHECK(end - begin <= 80);
      begin = end + 1;
    }
  }
}

TEST_CASE_METHOD(UsageTest, "the first help names every command") {
  const auto result = Run({"--help"});
  CHECK(result.status == 0);
  for (const char* name :
       {"generate", "check", "inspect", "validate", "replay", "catalogue", "schema"}) {
    CHECK(result.out.find("\n  " + std::string(name) + " ") != std::string::npos);
  }
}

TEST_CASE_METHOD(UsageTest, "help COMMAND is COMMAND --help, and help alone is --help") {
  CHECK(Run({"help"}).out == Run({"--help"}).out);
  CHECK(Run({"help", "preview"}).out == Run({"preview", "--help"}).out);
  CHECK(WrongUsage({"help", "preveiw"}) ==
        "mjforge: error: there is no command 'preveiw'; did you mean 'preview'?");
}

TEST_CASE_METHOD(UsageTest,
                 "with --version names mjforge and the libraries that shape its output") {
  const auto result = Run({"--version"});
  CHECK(result.status == 0);
  CHECK(result.out.starts_with("mjforge "));
  for (const char* name : {"\nMuJoCo ", "\nyaml-cpp ", "\nBoost ", "\nEigen "}) {
    CHECK(result.out.find(name) != std::string::npos);
  }
}

}  // namespace
}  // namespace mjforge
