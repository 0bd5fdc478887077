// The error catalogue: docs/errors.md, other cases and the program have the same codes.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "golden/error_pages.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "mjforge/diag/diag.h"

namespace mjforge::golden {
namespace {

namespace fs = std::filesystem;
using docs::kRoot;

// Codes that no command can provoke, and the unit test that does instead.
struct Unreachable {
  std::string code;
  std::string file;
  std::string test;
};
const std::vector<Unreachable> kUnreachable = {
    {"mujoco/mismatch", "tests/unit/validate/mismatch_test.cc",
     "another mass, centre or inertia of a body is found"},
    {"physics/inertia", "tests/unit/static_checks/proportions_test.cc",
     "an inertia that no solid has is an error"},
};

// Codes of what has no place in a text, such as a file that is not there.
const std::set<std::string> kWithoutPlace = {
    "yaml/cannot-read",      "output/exists",           "output/cannot-write",
    "output/bad-name",       "output/bad-manifest",     "output/differs",
    "batch/differs",         "batch/missing",           "batch/changed",
    "batch/uneven",          "batch/worker-died",       "batch/too-slow",
    "family/texture",        "picture/no-renderer",     "picture/nothing-visible",
    "picture/unknown-joint", "picture/bad-joint-value", "picture/no-viewer",
    "picture/no-display",    "report/no-picture",
};

std::vector<std::string> Codes() {
  std::vector<std::string> codes;
  for (const diag::CodeInfo& info : diag::AllCodes()) codes.emplace_back(info.name);
  return codes;
}

std::vector<std::string> Matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

std::vector<ErrorCase> AllCases() {
  std::vector<ErrorCase> cases = ReadCases(ErrorCatalogue());
  for (const fs::path& page : CasePages())
    std::ranges::move(ReadCases(page), std::back_inserter(cases));
  return cases;
}

TEST_CASE("the error catalogue has one chapter for each code, in the program's order") {
  const std::string page = harness::ReadFile(ErrorCatalogue());
  CHECK(Matches(page, std::regex("(?:^|\n)## ([^\n]+)")) == Codes());
}

TEST_CASE("each code has an example, or a unit test where no command provokes it") {
  std::set<std::string> seen;
  for (const ErrorCase& example : ReadCases(ErrorCatalogue())) seen.insert(example.Code());
  std::set<std::string> listed;
  for (const Unreachable& each : kUnreachable) {
    INFO(each.code << " in " << each.file);
    const std::string source = harness::ReadFile(kRoot / each.file);
    CHECK(source.find("TEST_CASE(\"" + each.test) != std::string::npos);
    CHECK_FALSE(seen.contains(each.code));  // else the list is out of date
    listed.insert(each.code);
  }
  for (const std::string& code : Codes()) {
    INFO(code);
    CHECK((seen.contains(code) || listed.contains(code)));
  }
}

TEST_CASE("each case shows the code that its heading names, with its place") {
  const std::vector<std::string> codes = Codes();
  for (const ErrorCase& example : AllCases()) {
    INFO(example.heading);
    const std::string code = example.Code();
    CHECK(std::ranges::find(codes, code) != codes.end());
    const std::string place = kWithoutPlace.contains(code) ? "" : "[^\\s:][^:\n]*:[0-9]+:[0-9]+: ";
    const std::regex line("(?:^|\n)" + place + "[^\n]*(?:error|warning): [^\n]*\\[(" + code +
                          ")\\]");
    std::string output;
    std::set<std::string> commands;
    for (const docs::Step& step : example.steps) {
      if (step.kind != docs::Step::Kind::kCommand) continue;
      INFO(step.name);
      CHECK(commands.insert(step.name).second);  // finds the output with another MuJoCo
      output += step.text;
    }
    CHECK(std::regex_search(output, line));
    for (const std::string& other : Matches(output, std::regex("\\[([a-z]+/[a-z-]+)\\]"))) {
      INFO(other);
      CHECK(std::ranges::find(codes, other) != codes.end());
    }
  }
}

TEST_CASE("each output of another MuJoCo belongs to a case") {
  std::set<std::string> cases;
  for (const ErrorCase& example : ReadCases(ErrorCatalogue())) {
    cases.insert("docs/errors.md: " + example.heading);
  }
  for (const fs::path& page : CasePages()) {
    for (const ErrorCase& example : ReadCases(page)) {
      INFO(example.heading);
      CHECK(cases.insert(page.lexically_relative(kRoot).string() + ": " + example.heading).second);
    }
  }
  for (const ErrorCase& other : ReadCases(kRoot / "tests/golden/with-mujoco-4.md")) {
    INFO(other.heading);
    CHECK(cases.contains(other.heading));
  }
}

}  // namespace
}  // namespace mjforge::golden
