#include <catch2/catch.hpp>

#include "golden/error_pages.h"
#include "golden/golden_case.h"
#include "harness/effort.h"

namespace mjforge::golden {
namespace {

// The fuzzers read such specs, too.
std::size_t Stride() { return static_cast<std::size_t>(harness::Effort(1, 3)); }

TEST_CASE("every example of the error catalogue gives the output that is shown") {
  CheckPage(ErrorCatalogue(), Stride());
}

TEST_CASE("every other case of an error gives the output that is shown") {
  for (const std::filesystem::path& page : CasePages()) CheckPage(page, Stride());
}

TEST_CASE("every good spec gives the bytes that are written beside it") {
  const std::vector<GoldenCase> cases = GoodCases();
  REQUIRE(cases.size() >= 12);
  for (const GoldenCase& golden : cases) CheckCase(golden);
}

}  // namespace
}  // namespace mjforge::golden
