#include "golden/golden_case.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>

#include "golden/shell.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"

namespace mjforge::golden {
namespace {

namespace fs = std::filesystem;

/// What a case says with a MuJoCo of 3.0 or later, where that differs: in MuJoCo's own words, in
/// depths of contact, and in what is simulated.
constexpr const char* kWithAnother = "expected-mujoco-4.txt";

bool IsAnother() {
  static const bool is_another =
      RunLine("mjforge --version", fs::temp_directory_path(), true).out.find("\nMuJoCo 2.") ==
      std::string::npos;
  return is_another;
}

const fs::path kRoot = harness::SourceFolder() / "tests/golden";

bool IsCase(const fs::path& folder) {
  return fs::exists(folder / "spec.yaml") || fs::exists(folder / "command");
}

std::string CommandOf(const fs::path& folder, const std::string& default_command) {
  if (!fs::exists(folder / "command")) return default_command;
  std::string line = harness::ReadFile(folder / "command");
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

void AddCases(const fs::path& folder, const std::string& default_command,
              std::vector<GoldenCase>& cases) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_directory()) continue;
    if (IsCase(entry.path())) {
      cases.push_back({entry.path(), entry.path().lexically_relative(kRoot).string(),
                       CommandOf(entry.path(), default_command)});
    } else {
      AddCases(entry.path(), default_command, cases);
    }
  }
}

std::string Run(const GoldenCase& golden, bool merged, harness::CommandResult& result) {
  const harness::TemporaryFolder copy;
  fs::copy(golden.folder, copy.path(), fs::copy_options::recursive);
  fs::remove(copy / "expected.txt");
  fs::remove(copy / "expected.xml");
  fs::remove(copy / kWithAnother);
  fs::remove(copy / "command");
  result = RunLine(golden.command, copy.path(), merged);
  return merged ? WithoutTimes(result.out) + "exit: " + std::to_string(result.status) + "\n"
                : result.out;
}

void Update(const GoldenCase& golden) {
  harness::CommandResult result;
  std::string made = Run(golden, false, result);
  const bool is_xml = made.starts_with("<") && result.err.empty() && result.status == 0;
  if (!is_xml) made = Run(golden, true, result);
  const fs::path old = golden.ExpectedFile();
  fs::path file = golden.folder / (is_xml ? "expected.xml" : "expected.txt");
  if (IsAnother() && !old.empty() && harness::ReadFile(old) != made)
    file = golden.folder / kWithAnother;
  if (!old.empty() && harness::ReadFile(old) == made) return;
  std::ofstream(file, std::ios::binary) << made;
  FAIL_CHECK("rewrote " << file.string());
}

}  // namespace

fs::path GoldenCase::ExpectedFile() const {
  if (IsAnother() && fs::exists(folder / kWithAnother)) return folder / kWithAnother;
  for (const char* file : {"expected.xml", "expected.txt"}) {
    if (fs::exists(folder / file)) return folder / file;
  }
  return {};
}

std::vector<GoldenCase> FindCases(const std::string& kind, const std::string& default_command) {
  std::vector<GoldenCase> cases;
  AddCases(kRoot / kind, default_command, cases);
  std::ranges::sort(cases, {}, &GoldenCase::name);
  return cases;
}

void CheckCase(const GoldenCase& golden) {
  INFO(golden.name << ": " << golden.command);
  if (std::getenv("MJFORGE_UPDATE") != nullptr) return Update(golden);
  const fs::path expected = golden.ExpectedFile();
  if (expected.empty()) {
    FAIL_CHECK("no expected.xml or expected.txt; MJFORGE_UPDATE=1 writes it");
    return;
  }
  harness::CommandResult result;
  const bool is_xml = expected.extension() == ".xml";
  const std::string made = Run(golden, !is_xml, result);
  CHECK(made == harness::ReadFile(expected));
  if (!is_xml) return;
  CHECK(result.err == "");
  CHECK(result.status == 0);
}

}  // namespace mjforge::golden
