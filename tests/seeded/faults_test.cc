// The physical checks find faults that are put into bundled specs, and nothing in the specs as they
// are. docs/physics.md has the table.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>
#include <catch2/catch.hpp>

#include "harness/command.h"
#include "harness/source_folder.h"
#include "mjforge/diag/diag.h"

namespace mjforge {
namespace {

struct Fault {
  std::string spec;
  std::string fault;
  std::string replace;
  std::string with;
  std::string finds;   // a code; empty: nothing does
  std::string missed;  // why, then
  std::string set;     // a threshold or a parameter, NAME=VALUE; empty: none
};

std::filesystem::path Specs() { return harness::SourceFolder() / "specs"; }

std::vector<Fault> Faults() {
  std::vector<Fault> faults;
  const auto text = [](const YAML::Node& node) { return node ? node.as<std::string>() : ""; };
  for (const YAML::Node& node :
       YAML::LoadFile((harness::SourceFolder() / "tests/seeded/faults.yaml").string())) {
    faults.push_back({text(node["spec"]), text(node["fault"]), text(node["replace"]),
                      text(node["with"]), text(node["finds"]), text(node["missed"]),
                      text(node["set"])});
  }
  return faults;
}

class SeededTest : public harness::ProgramTest {
 protected:
  /// Faulty specs stand among the bundled ones, which name others by where they are.
  SeededTest() {
    std::filesystem::copy(Specs(), folder() / "specs", std::filesystem::copy_options::recursive);
  }

  /// What `check` says of a spec.
  std::string Check(const std::string& spec, const std::string& set) const {
    std::vector<std::string> words = {
        "check", "specs/" + spec + ".yaml", "-n", "3", "--physics", "--findings", "json", "-q"};
    if (!set.empty()) words.insert(words.end(), {"--set", set});
    const auto result = Run(words);
    CHECK(result.status < 2);
    return result.err;
  }
};

std::string Table(const std::vector<Fault>& faults) {
  std::string table = "| spec | what is wrong with it | found as |\n| --- | --- | --- |\n";
  for (const Fault& fault : faults) {
    table += fmt::format(
        "| `{}` | {}{} | {} |\n", fault.spec, fault.fault,
        fault.set.empty() ? "" : fmt::format(" (`--set {}`)", fault.set),
        fault.finds.empty() ? "not found: " + fault.missed : fmt::format("`{}`", fault.finds));
  }
  return table;
}

}  // namespace

TEST_CASE_METHOD(SeededTest, "physical checks find faults that are put into bundled specs") {
  int found = 0;
  for (const Fault& fault : Faults()) {
    INFO(fault.spec << ": " << fault.fault);
    std::string text = harness::ReadFile(Specs() / (fault.spec + ".yaml"));
    const std::size_t at = text.find(fault.replace);
    REQUIRE(at != text.npos);
    REQUIRE(text.find(fault.replace, at + 1) == text.npos);
    const std::string faulty = fault.spec + "_faulty";
    folder().Write("specs/" + faulty + ".yaml", text.replace(at, fault.replace.size(), fault.with));
    const std::string findings = Check(faulty, fault.set);
    INFO(findings);
    if (fault.finds.empty()) {
      CHECK(findings.empty());
      continue;
    }
    CHECK(findings.find(fmt::format("\"{}\"", fault.finds)) != findings.npos);
    ++found;
  }
  CHECK(found >= 100);
}

TEST_CASE("each physical check has a fault that it finds, but for those of MJCF files alone") {
  // Only an attached file can state an inertia.
  std::set<std::string> found = {"physics/inertia", "physics/center-of-mass"};
  for (const Fault& fault : Faults()) found.insert(fault.finds);
  for (const diag::CodeInfo& code : diag::AllCodes()) {
    if (!code.name.starts_with("physics/")) continue;
    INFO(code.name);
    CHECK(found.contains(std::string(code.name)));
  }
}

TEST_CASE_METHOD(SeededTest, "physical checks find nothing in the same specs without the faults") {
  std::set<std::pair<std::string, std::string>> specs;
  for (const Fault& fault : Faults()) specs.emplace(fault.spec, fault.set);
  for (const auto& [spec, set] : specs) {
    INFO(spec << " " << set);
    CHECK(Check(spec, set).empty());
  }
}

TEST_CASE("the table of faults in the docs is that of the tests") {
  const std::filesystem::path file = harness::SourceFolder() / "docs/physics.md";
  std::string page = harness::ReadFile(file);
  const std::string table = Table(Faults());
  const std::size_t start = page.find(table.substr(0, table.find('\n')));
  REQUIRE(start != page.npos);
  const std::size_t end = page.find("\n\n", start) + 1;
  const bool is_same = page.compare(start, end - start, table) == 0;
  CHECK(is_same);
  if (!is_same && std::getenv("MJFORGE_UPDATE") != nullptr)
    std::ofstream(file) << page.replace(start, end - start, table);
}

}  // namespace mjforge
