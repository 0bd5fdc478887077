#include "mjforge/diag/codes.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

using namespace mjforge::diag;

TEST_CASE("every code has a name of a stage and kebab-case words") {
  const std::set<std::string> stages = {"yaml",   "expr",    "spec",   "sample",  "model",
                                        "attach", "target",  "mujoco", "physics", "output",
                                        "batch",  "picture", "report", "start",   "family"};
  for (const CodeInfo& info : AllCodes()) {
    const std::string name(info.name);
    CAPTURE(name);
    const auto slash = name.find('/');
    REQUIRE(slash != std::string::npos);
    CHECK(stages.count(name.substr(0, slash)) == 1);
    const std::string rest = name.substr(slash + 1);
    CHECK(!rest.empty());
    CHECK(rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos);
  }
}

TEST_CASE("no two codes share a name") {
  std::set<std::string_view> names;
  for (const CodeInfo& info : AllCodes()) {
    CAPTURE(info.name);
    CHECK(names.insert(info.name).second);
  }
}

TEST_CASE("a code's meaning is one line without a final stop") {
  for (const CodeInfo& info : AllCodes()) {
    CAPTURE(info.name);
    REQUIRE(!info.meaning.empty());
    CHECK(info.meaning.find('\n') == std::string_view::npos);
    CHECK(info.meaning.back() != '.');
  }
}

TEST_CASE("codes are found by their names") {
  CHECK(CodeName(Code::kYamlCannotRead) == "yaml/cannot-read");
  CHECK(CodeName(Code::kExprUnknownName) == "expr/unknown-name");
  CHECK(CodeName(Code::kSpecUnknownKey) == "spec/unknown-key");
  CHECK(CodeName(Code::kSpecVersion) == "spec/version");
  CHECK(CodeName(Code::kSampleRejected) == "sample/rejected");
  CHECK(CodeName(Code::kModelNoMass) == "model/no-mass");
  CHECK(CodeName(Code::kMujocoNotMjcf) == "mujoco/not-mjcf");
  CHECK(CodeName(Code::kOutputDiffers) == "output/differs");
}

TEST_CASE("only files that cannot be read or written are failures of input or output") {
  std::set<std::string_view> failures;
  for (const CodeInfo& info : AllCodes()) {
    if (IsInputOutput(info.code)) failures.insert(info.name);
  }
  CHECK(failures ==
        std::set<std::string_view>{"yaml/cannot-read", "output/exists", "output/cannot-write"});
}
