// The error catalogue: docs/errors.md, the golden cases and the program know the
// same codes.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "golden/golden_case.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "mjforge/diag/diag.h"

namespace mjforge::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = harness::SourceFolder();

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
    "batch/uneven",          "picture/no-renderer",     "picture/nothing-visible",
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

// "errors/spec-bad-value-number/zero" -> "spec/bad-value"; the longest code that fits.
std::string CodeOf(const GoldenCase& golden) {
  const std::string name = golden.name.substr(std::string("errors/").size());
  std::string best;
  for (const std::string& code : Codes()) {
    std::string folder = code;
    std::ranges::replace(folder, '/', '-');
    if (name.starts_with(folder) && code.size() > best.size()) best = code;
  }
  return best;
}

std::vector<GoldenCase> ErrorCases() { return FindCases("errors", {}); }

TEST_CASE("the error catalogue has one chapter for each code, in the program's order") {
  const std::string page = harness::ReadFile(kRoot / "docs/errors.md");
  CHECK(Matches(page, std::regex("(?:^|\n)## ([^\n]+)")) == Codes());
}

TEST_CASE("each code has a golden case, or a unit test where no command provokes it") {
  std::set<std::string> seen;
  for (const GoldenCase& golden : ErrorCases()) seen.insert(CodeOf(golden));
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

TEST_CASE("each error case shows the code its folder is named after, with its place") {
  const std::vector<std::string> codes = Codes();
  for (const GoldenCase& golden : ErrorCases()) {
    INFO(golden.name);
    const std::string code = CodeOf(golden);
    CHECK(code != "");
    const std::string output = harness::ReadFile(golden.folder / "expected.txt");
    const std::string place = kWithoutPlace.contains(code) ? "" : "[^\\s:][^:\n]*:[0-9]+:[0-9]+: ";
    const std::regex line("(?:^|\n)" + place + "[^\n]*(?:error|warning): [^\n]*\\[(" + code +
                          ")\\]");
    CHECK(std::regex_search(output, line));
    for (const std::string& other : Matches(output, std::regex("\\[([a-z]+/[a-z-]+)\\]"))) {
      INFO(other);
      CHECK(std::ranges::find(codes, other) != codes.end());
    }
  }
}

}  // namespace
}  // namespace mjforge::golden
