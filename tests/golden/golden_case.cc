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

std::string CommandOf(const fs::path& folder) {
  if (!fs::exists(folder / "command")) return "mjforge generate spec.yaml --seed 1 -o -";
  std::string line = harness::ReadFile(folder / "command");
  while (line.ends_with('\n')) line.pop_back();
  return line;
}

std::string Run(const GoldenCase& golden, bool merged, harness::CommandResult& result) {
  const harness::TemporaryFolder copy;
  fs::copy(golden.folder, copy.path(), fs::copy_options::recursive);
  fs::remove(copy / "expected.txt");
  fs::remove(copy / "expected.xml");
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
  const fs::path file = golden.folder / (is_xml ? "expected.xml" : "expected.txt");
  if (!old.empty() && harness::ReadFile(old) == made) return;
  std::ofstream(file, std::ios::binary) << made;
  FAIL_CHECK("rewrote " << file.string());
}

}  // namespace

fs::path GoldenCase::ExpectedFile() const {
  for (const char* file : {"expected.xml", "expected.txt"}) {
    if (fs::exists(folder / file)) return folder / file;
  }
  return {};
}

std::vector<GoldenCase> GoodCases() {
  std::vector<GoldenCase> cases;
  for (const auto& entry : fs::directory_iterator(harness::SourceFolder() / "tests/golden/good")) {
    cases.push_back({entry.path(), CommandOf(entry.path())});
  }
  std::ranges::sort(cases, {}, &GoldenCase::folder);
  return cases;
}

void CheckCase(const GoldenCase& golden) {
  INFO(golden.folder.filename().string() << ": " << golden.command);
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
