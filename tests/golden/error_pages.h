// Pages with examples of errors: docs/errors.md, and tests/golden/errors for what it does not show.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "docs/page.h"

namespace mjforge::golden {

/// A chapter of a page: files, and commands with their outputs.
struct ErrorCase {
  std::string heading;  // a code, or a code and more: "spec/bad-value: colour"
  std::vector<docs::Step> steps;

  std::string Code() const { return heading.substr(0, heading.find(':')); }
};

/// Returns the cases of a page, in its order. Chapters without commands are left out.
std::vector<ErrorCase> ReadCases(const std::filesystem::path& page);

/// docs/errors.md, which users read. Its chapters share a folder, and an output is that of a
/// command that fails if it has an error.
std::filesystem::path ErrorCatalogue();

/// The pages of tests/golden/errors, sorted. Each chapter begins in an empty folder, and each
/// output ends with a line `exit: STATUS`.
std::vector<std::filesystem::path> CasePages();

/// Runs every `step`th case of a page and compares. With MJFORGE_UPDATE=1 it writes what came out
/// to the page and fails nevertheless, so that an update is never a pass.
///
/// With MuJoCo 3.0 or later some outputs differ: in MuJoCo's own words, in depths of contacts, and
/// in what is simulated. Those are in tests/golden/with-mujoco-4.md, in chapters that have the name
/// of the page before the heading: "docs/errors.md: mujoco/error".
void CheckPage(const std::filesystem::path& page, std::size_t step);

}  // namespace mjforge::golden
