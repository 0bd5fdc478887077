// What the pages say is what the program does: their files are written, their
// commands run in order, their outputs compared.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "docs/page.h"
#include "golden/shell.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"

namespace mjforge::docs {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> Pages() {
  std::vector<fs::path> pages = {kRoot / "README.md"};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

// What came out where it is not what the page shows.
std::optional<std::string> RunCommand(const Step& step, const fs::path& folder) {
  const harness::CommandResult result = golden::RunLine(step.name, folder, true);
  // A page shows a failure only where it talks of one.
  CHECK((result.status == 0 || result.out.find("error") != std::string::npos));
  if (Fits(golden::WithoutTimes(result.out), golden::WithoutTimes(step.text))) return std::nullopt;
  return result.out;
}

// With MJFORGE_UPDATE=1 the page is rewritten, and the test fails nevertheless.
void CheckPage(const fs::path& page) {
  const harness::TemporaryFolder folder;
  std::map<int, std::string> outputs;
  for (const Step& step : ReadSteps(page)) {
    INFO(page.filename().string() << ":" << step.line << ": $ " << step.name);
    if (step.kind == Step::Kind::kFile) {
      folder.Write(step.name, step.text);
      continue;
    }
    const std::optional<std::string> other = RunCommand(step, folder.path());
    if (!other) continue;
    UNSCOPED_INFO("-- gave\n" << *other << "-- instead of\n" << step.text);
    FAIL_CHECK("the page shows another output; MJFORGE_UPDATE=1 rewrites it");
    outputs[step.line] = *other;
  }
  if (std::getenv("MJFORGE_UPDATE") != nullptr && !outputs.empty()) ReplaceOutputs(page, outputs);
}

TEST_CASE("every command on the pages gives the output that is shown") {
  for (const fs::path& page : Pages()) {
    // golden_test runs the examples of errors.md, with other MuJoCos, too.
    if (page.filename() != "errors.md") CheckPage(page);
  }
}

TEST_CASE("there are pages with commands to run") {
  std::size_t commands = 0;
  for (const fs::path& page : Pages()) {
    for (const Step& step : ReadSteps(page)) commands += step.kind == Step::Kind::kCommand;
  }
  CHECK(commands >= 80);
}

TEST_CASE("every link between the pages leads to a file and a chapter") {
  for (const fs::path& page : Pages()) {
    for (const std::string& link : ReadLinks(page)) {
      INFO(page.filename().string() << ": " << link);
      if (link.starts_with("http")) continue;
      const std::size_t hash = std::min(link.find('#'), link.size());
      const fs::path target = hash == 0 ? page : page.parent_path() / link.substr(0, hash);
      CHECK(fs::exists(target));
      if (hash == link.size() || !fs::exists(target)) continue;
      const std::vector<std::string> anchors = ReadAnchors(target);
      CHECK(std::find(anchors.begin(), anchors.end(), link.substr(hash + 1)) != anchors.end());
    }
  }
}

TEST_CASE("a line of three dots stands for any lines") {
  CHECK(Fits("a\nb\nc\n", "a\nb\nc\n"));
  CHECK(Fits("a\nb\nc\n", "a\n...\n"));
  CHECK(Fits("a\nb\nc\n", "...\nc\n"));
  CHECK_FALSE(Fits("a\nb\nc\n", "a\n...\nd\n"));
  CHECK_FALSE(Fits("a\nb\n", "a\n"));
  CHECK_FALSE(Fits("a\n", "a\nb\n"));
}

}  // namespace
}  // namespace mjforge::docs
