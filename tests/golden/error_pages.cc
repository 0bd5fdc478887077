// Runs the examples of pages, with the outputs of another MuJoCo where these differ.

#include "golden/error_pages.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <map>

#include "golden/shell.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"

namespace mjforge::golden {
namespace {

namespace fs = std::filesystem;
using docs::kRoot;
using docs::Step;

const fs::path kWithAnother = kRoot / "tests/golden/with-mujoco-4.md";

bool IsUpdate() { return std::getenv("MJFORGE_UPDATE") != nullptr; }

/// Outputs that are shown, for the MuJoCo at hand, and what came out where it is another.
class Outputs {
 public:
  explicit Outputs(const fs::path& page) : page_(page) {
    if (HasAnotherMujoco()) others_ = ReadCases(kWithAnother);
  }

  /// Returns the step that shows the output: the page's own, or the other MuJoCo's.
  const Step& Shown(const ErrorCase& example, const Step& step) const {
    const auto other = std::ranges::find(others_, Heading(example), &ErrorCase::heading);
    if (other == others_.end()) return step;
    const auto same = std::ranges::find(other->steps, step.name, &Step::name);
    return same != other->steps.end() ? *same : step;
  }

  void Replace(const ErrorCase& example, const Step& step, const std::string& output) {
    const Step& shown = Shown(example, step);
    if (!HasAnotherMujoco()) {
      own_[step.line] = output;
    } else if (&shown != &step) {
      another_[shown.line] = output;
    } else {
      new_ +=
          "\n## " + Heading(example) + "\n\n```console\n$ " + step.name + "\n" + output + "```\n";
    }
  }

  /// Writes the replacements to the pages.
  void Write() const {
    if (!own_.empty()) docs::ReplaceOutputs(page_, own_);
    if (!another_.empty()) docs::ReplaceOutputs(kWithAnother, another_);
    std::ofstream(kWithAnother, std::ios::binary | std::ios::app) << new_;
  }

 private:
  std::string Heading(const ErrorCase& example) const {
    return page_.lexically_relative(kRoot).generic_string() + ": " + example.heading;
  }

  fs::path page_;
  std::vector<ErrorCase> others_;
  std::map<int, std::string> own_, another_;  // by line
  std::string new_;                           // chapters
};

void CheckCommand(const ErrorCase& example, const Step& step, const fs::path& folder,
                  bool has_status, Outputs& outputs) {
  INFO(example.heading << ": $ " << step.name);
  const harness::CommandResult result = RunLine(step.name, folder, true);
  std::string output = result.out;
  if (has_status) {
    output += "exit: " + std::to_string(result.status) + "\n";
  } else {
    CHECK((result.status != 0) == (output.find("error: ") != std::string::npos));
  }
  const std::string shown = WithoutTimes(outputs.Shown(example, step).text);
  if (!IsUpdate()) {
    CHECK(WithoutTimes(output) == shown);
  } else if (WithoutTimes(output) != shown) {
    FAIL_CHECK("rewrote the output");
    outputs.Replace(example, step, has_status ? WithoutTimes(output) : output);
  }
}

}  // namespace

std::vector<ErrorCase> ReadCases(const fs::path& page) {
  std::vector<ErrorCase> cases;
  for (Step& step : docs::ReadSteps(page)) {
    if (cases.empty() || cases.back().heading != step.chapter) {
      cases.push_back({step.chapter, {}});
    }
    cases.back().steps.push_back(std::move(step));
  }
  return cases;
}

fs::path ErrorCatalogue() { return kRoot / "docs/errors.md"; }

std::vector<fs::path> CasePages() {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::directory_iterator(kRoot / "tests/golden/errors")) {
    pages.push_back(entry.path());
  }
  std::ranges::sort(pages);
  return pages;
}

void CheckPage(const fs::path& page, std::size_t step) {
  INFO(page.filename().string());
  const bool is_catalogue = page == ErrorCatalogue();
  const std::vector<ErrorCase> cases = ReadCases(page);
  Outputs outputs(page);
  const harness::TemporaryFolder whole_page;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const harness::TemporaryFolder own;
    const harness::TemporaryFolder& folder = is_catalogue ? whole_page : own;
    for (const Step& each : cases[i].steps) {
      if (each.kind == Step::Kind::kFile) {
        folder.Write(each.name, each.text);
      } else if (i % step == 0) {
        CheckCommand(cases[i], each, folder.path(), !is_catalogue, outputs);
      }
    }
  }
  if (IsUpdate()) outputs.Write();
}

}  // namespace mjforge::golden
