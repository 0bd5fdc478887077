// The scripts of app/completions in the real shells.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "harness/command.h"
#include "harness/source_folder.h"

namespace mjforge {
namespace {

using Words = std::vector<std::string>;

class Shells {
 protected:
  Shells() {
    folder_.Write("home/.config/fish/config.fish", "");  // its own, or fish makes one
    folder_.Write("here/crate.yaml", kText);
    folder_.Write("here/my specs/tub.yml", kText);
    folder_.Write("here/notes.txt", "");
    folder_.Write("here/robot.xml", "");
    folder_.Write("here/pages/a.html", "");
  }

  std::string Ask(const std::string& shell, const std::string& line, Words more = {}) const {
    const auto source = harness::SourceFolder();
    Words arguments = {source / "tests/completion/ask." += shell, source / "app/completions", line};
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (shell == "zsh") arguments.insert(arguments.begin(), "-f");
    const harness::Command command{
        .program = shell,
        .arguments = arguments,
        .environment = {{"PATH", harness::MjforgeProgram().parent_path().string() + ":" +
                                     std::getenv("PATH")},
                        {"HOME", (folder_ / "home").string()},
                        {"XDG_CONFIG_HOME", (folder_ / "home/.config").string()},
                        {"XDG_DATA_HOME", (folder_ / "home/.local/share").string()},
                        {"TERM", "dumb"}},
        .folder = folder_ / "here"};
    const harness::CommandResult result = command.Run();
    CHECK(result.status == 0);
    CHECK_FALSE(result.timed_out);
    return result.out;
  }

  // Sorted, without meanings and without the slash that some shells put behind a folder.
  Words Offered(const std::string& shell, const std::string& line) const {
    Words words;
    const std::string answer = Ask(shell, line);
    for (std::size_t at = 0; at < answer.size(); at = answer.find('\n', at) + 1) {
      std::string word = answer.substr(at, answer.find('\n', at) - at);
      word.erase(std::min(word.find('\t'), word.size()));
      if (word.ends_with('/')) word.pop_back();
      if (!word.empty() && word != ".hits") words.push_back(word);
    }
    std::sort(words.begin(), words.end());
    return words;
  }

 private:
  static constexpr const char* kText =
      "mjforge: 1\n"
      "name: crate\n"
      "params: {height: {value: 0.1 .. 0.2, doc: Half of it.}, wood: {choice: [oak, dark pine]}}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n";

  harness::TemporaryFolder folder_;
};

struct Case {
  std::string line;
  Words offered;
};

TEST_CASE_METHOD(Shells, "bash, zsh and fish complete what the program says") {
  const std::vector<Case> cases = {
      {"mjforge gen", {"generate"}},
      {"mjforge check --see", {"--seed"}},
      {"mjforge generate crate.yaml --target m", {"mjx", "mujoco"}},
      {"mjforge inspect hamm", {"hammer"}},
      {"mjforge generate crate.yaml -n 5 --set ", {"height=", "wood="}},
      {"mjforge nosuch ", {}},
      // Files, and folders that may have some.
      {"mjforge validate ", {"my specs", "pages", "robot.xml"}},
      {"mjforge generate crate.yaml --params ", {"crate.yaml", "my specs", "pages"}},
      {"mjforge generate crate.yaml -o ",
       {"crate.yaml", "my specs", "notes.txt", "pages", "robot.xml"}},
      {"mjforge report . -o pages/", {"pages/a.html"}},
      // Names and files.
      {"mjforge check cra", {"crate", "crate.yaml"}},
      {"mjforge check primitives/b", {"primitives/ball", "primitives/box"}},
  };
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    for (const Case& expected : cases) {
      INFO(shell << ": " << expected.line);
      CHECK(Offered(shell, expected.line) == expected.offered);
    }
  }
}

TEST_CASE_METHOD(Shells, "what follows an equals sign is completed, too") {
  // For bash it is a word of its own.
  const std::string line = "mjforge generate crate.yaml ";
  CHECK(Offered("bash", line + "--target=m") == Words{"mjx", "mujoco"});
  CHECK(Offered("bash", line + "--set wood=") == Words{"dark\\ pine", "oak"});
  CHECK(Offered("bash", line + "--set=wood=o") == Words{"oak"});
  CHECK(Offered("bash", line + "--params=cr") == Words{"crate.yaml"});
  for (const std::string shell : {"zsh", "fish"}) {
    INFO(shell);
    CHECK(Offered(shell, line + "--target=m") == Words{"--target=mjx", "--target=mujoco"});
    CHECK(Offered(shell, line + "--set wood=") == Words{"wood=dark pine", "wood=oak"});
    CHECK(Offered(shell, line + "--params=cr") == Words{"--params=crate.yaml"});
  }
}

TEST_CASE_METHOD(Shells, "a spec whose name has a blank is understood") {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    INFO(shell);
    CHECK(Offered(shell, R"(mjforge check my\ specs/tub.yml --set h)") == Words{"height="});
  }
}

TEST_CASE_METHOD(Shells, "lists say what the words mean") {
  CHECK(Ask("fish", "mjforge check crate.yaml --set h") == "height=\tHalf of it.\n");
  const std::string kListing = "63";  // bash's number for it
  CHECK(Ask("bash", "mjforge check --p", {kListing}) ==
        "--place-seed             Seed of the draws of `place:` alone\n"
        "--params                 Set parameters from a YAML mapping\n"
        "--physics                Simulate each: does it behave?\n"
        "--profile                More tests, by name: simready\n");
  CHECK(Ask("bash", "mjforge check --p") == "--place-seed\n--params\n--physics\n--profile\n");
}

}  // namespace
}  // namespace mjforge
