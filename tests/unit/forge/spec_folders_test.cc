#include <catch2/catch.hpp>
#include <cstdlib>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// Sets MJFORGE_PATH for one test.
class SearchPathVariable {
 public:
  explicit SearchPathVariable(const char* value) { ::setenv("MJFORGE_PATH", value, 1); }
  ~SearchPathVariable() { ::unsetenv("MJFORGE_PATH"); }
};

std::vector<std::filesystem::path> WithoutCatalogue() {
  std::vector<std::filesystem::path> folders = SearchPath();
  if (CatalogueFolder()) {
    REQUIRE(folders.back() == *CatalogueFolder());
    folders.pop_back();
  }
  return folders;
}

TEST_CASE("the folders of MJFORGE_PATH come first, empty ones left out") {
  using Folders = std::vector<std::filesystem::path>;
  {
    const SearchPathVariable variable("/a:b/c::d:");
    CHECK(WithoutCatalogue() == Folders{"/a", "b/c", "d"});
  }
  {
    const SearchPathVariable variable("");
    CHECK(WithoutCatalogue().empty());
  }
}

TEST_CASE("specs that came with a package win over those beside the program") {
  const SearchPathVariable variable("/a");
  CHECK(SearchPath("/package/specs") == std::vector<std::filesystem::path>{"/a", "/package/specs"});
}

TEST_CASE("every library whose version matters is named with its version") {
  for (const Library& library : Libraries()) {
    CHECK_FALSE(library.version.empty());
    CHECK(library.version.find_first_not_of("0123456789.") == std::string::npos);
  }
  CHECK(Libraries().front().name == "MuJoCo");
}

}  // namespace
}  // namespace mjforge::forge
