// What the pages say is what the program does: their files are written, their
// commands run in order, their outputs compared.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "docs/page.h"
#include "golden/shell.h"
#include "harness/temporary_folder.h"

namespace mjforge::docs {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = MJFORGE_SOURCE_DIR;

std::vector<fs::path> Pages() {
  std::vector<fs::path> pages = {kRoot / "README.md"};
  for (const auto& entry : fs::directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

void Do(const Step& step, const harness::TemporaryFolder& folder) {
  if (step.kind == Step::Kind::kFile) {
    folder.Write(step.name, step.text);
    return;
  }
  const harness::CommandResult result = golden::RunLine(step.name, folder.path(), true);
  const std::string output = golden::WithoutTimes(result.out);
  const std::string expected = golden::WithoutTimes(step.text);
  INFO("$ " << step.name << "\n" << output << "-- instead of\n" << expected);
  CHECK(Fits(output, expected));
  // A page shows a failure only where it talks of one.
  CHECK((result.status == 0 || output.find("error: ") != std::string::npos));
}

TEST_CASE("every command on the pages gives the output that is shown") {
  std::size_t commands = 0;
  for (const fs::path& page : Pages()) {
    const harness::TemporaryFolder folder;
    for (const Step& step : ReadSteps(page)) {
      INFO(page.filename().string() << ":" << step.line);
      Do(step, folder);
      if (step.kind == Step::Kind::kCommand) ++commands;
    }
  }
  CHECK(commands >= 40);
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
