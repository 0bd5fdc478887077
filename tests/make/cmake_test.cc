// The same project built through CMake.

#include <catch2/catch.hpp>

#include "make/cases.h"
#include "make/project.h"

namespace mjforge::make {
namespace {

using Names = std::set<std::string>;

const std::vector<std::string> kBuild = {"--build", "build-cmake"};

void Configure(const Project& project, const std::string& generator) {
  project.Do("cmake", {"-S", ".", "-B", "build-cmake", "-G", generator, "-D",
                       "MJFORGE=" + harness::MjforgeProgram().string()});
  project.Do("cmake", kBuild);
}

// With the reports on the objects.
Names WithReports(Names targets) {
  Names more;
  for (std::string name : targets) {
    if (name.ends_with(".xml")) more.insert(name.replace(name.size() - 3, 3, "txt"));
  }
  more.merge(targets);
  return more;
}

TEST_CASE("Ninja makes again what was made from a changed file") {
  Project project;
  Configure(project, "Ninja");
  project.Age();
  CHECK(project.Do("cmake", kBuild).find("no work to do") != std::string::npos);
  for (const Dependents& expected : kDependents) {
    INFO(expected.file);
    project.Touch(expected.file);
    const std::string said = project.Do("cmake", kBuild);
    for (const std::string& name : WithReports(kTrays)) {
      const bool made = said.find("Generating " + name + "\n") != std::string::npos;
      CHECK(made == (expected.targets.contains(name) && !name.ends_with(".txt")));
    }
    for (const std::string& name : kDrawers) {
      if (name == "drawers.manifest.jsonl") continue;
      const bool made = said.find("Generating " + name + "\n") != std::string::npos;
      CHECK(made == expected.targets.contains(name));
    }
    // All that was made is as it was, which Ninja sees.
    CHECK(project.Fresh("build-cmake/").empty());
    CHECK(project.Do("cmake", kBuild).find("no work to do") != std::string::npos);
  }
  project.Change("materials.yaml", "density: 710", "density: 720");
  project.Do("cmake", kBuild);
  CHECK(project.Fresh("build-cmake/") == WithReports(kTrays));
  project.Change("parts/grip.obj", "v 1 0 0", "v 1.1 0 0");
  project.Do("cmake", kBuild);
  CHECK(project.Fresh("build-cmake/") == WithReports(kDrawers));
}

TEST_CASE("Makefiles of CMake make again what was made from a touched file") {
  Project project;
  Configure(project, "Unix Makefiles");
  project.Age();
  CHECK(project.Do("cmake", kBuild).find("Generating") == std::string::npos);
  for (const Dependents& expected : kDependents) {
    INFO(expected.file);
    project.Touch(expected.file);
    project.Do("cmake", kBuild);
    CHECK(project.Fresh("build-cmake/") == WithReports(expected.targets));
    CHECK(project.Do("cmake", kBuild).find("Generating") == std::string::npos);
  }
}

}  // namespace
}  // namespace mjforge::make
