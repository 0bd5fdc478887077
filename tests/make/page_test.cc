// docs/make.md shows the example's own files.

#include <catch2/catch.hpp>

#include "harness/source_folder.h"
#include "make/project.h"

namespace mjforge::make {
namespace {

std::string Page() { return harness::ReadFile(harness::SourceFolder() / "docs/make.md"); }

TEST_CASE("the page shows the files of the example as they are") {
  const std::string page = Page();
  const auto shows = [&](const std::string& kind, const std::string& name) {
    INFO(name);
    const std::string text = harness::ReadFile(Example() / name);
    CHECK(page.find("```" + kind + "\n" + text + "```\n") != std::string::npos);
  };
  shows("make", "Makefile");
  shows("make", "unchanged.mk");
  shows("cmake", "CMakeLists.txt");
}

TEST_CASE("the page shows what make says and the rule that comes out") {
  const auto shows = [](const std::string& kind, const std::string& text) {
    INFO(text);
    CHECK(Page().find("```" + kind + "\n" + text + "```\n") != std::string::npos);
  };
  Project project;
  project.Do("make", {"-j2"});
  shows("text", project.Do("make", {"-j2"}));
  shows("make", project.folder().Read("build/rack.d"));
  project.Touch("materials.yaml");
  shows("text", project.Do("make", {}));
  project.Do("make", {"-f", "unchanged.mk"});
  project.Touch("materials.yaml");
  shows("text", project.Do("make", {"-f", "unchanged.mk"}));
}

TEST_CASE("the rule for Ninja on the page stops at an unchanged object") {
  const std::string page = Page();
  const std::string fence = "```ninja\n";
  const std::size_t start = page.find(fence);
  REQUIRE(start != page.npos);
  Project project;
  project.folder().Write(
      "build.ninja",
      page.substr(start + fence.size(), page.find("```", start + 3) - start - fence.size()) +
          "rule report\n  command = mjforge inspect $in > $out\n"
          "build tray.txt: report tray.xml\n");
  project.Do("ninja", {"-v"});
  CHECK(project.Fresh("tray.") == std::set<std::string>{"txt", "xml"});
  project.Touch("materials.yaml");
  CHECK(project.Do("ninja", {"-v"}).find("generate") != std::string::npos);
  CHECK(project.Fresh("tray.").empty());
  CHECK(project.Do("ninja", {"-v"}).find("no work to do") != std::string::npos);
  project.Change("materials.yaml", "density: 710", "density: 720");
  project.Do("ninja", {"-v"});
  CHECK(project.Fresh("tray.") == std::set<std::string>{"txt", "xml"});
}

}  // namespace
}  // namespace mjforge::make
