#include "make/project.h"

#include <catch2/catch.hpp>
#include <cstdlib>

#include "harness/source_folder.h"

namespace mjforge::make {

namespace fs = std::filesystem;

fs::path Example() { return harness::SourceFolder() / "docs/examples/make"; }

namespace {

// By mjforge, or the report on what it made.
bool IsMade(const fs::path& name) {
  static const std::set<std::string> kinds = {".xml", ".txt", ".d", ".tar", ".jsonl"};
  return kinds.contains(name.extension().string()) && name.filename() != "CMakeCache.txt";
}

}  // namespace

Project::Project() {
  fs::copy(Example(), folder_.path(), fs::copy_options::recursive);
  past_ = fs::file_time_type::clock::now() - std::chrono::hours(24);
}

harness::CommandResult Project::Run(const std::string& program,
                                    std::vector<std::string> arguments) const {
  const char* path = std::getenv("PATH");
  const std::string programs = harness::MjforgeProgram().parent_path().string();
  harness::CommandResult result =
      harness::Command{.program = program,
                       .arguments = std::move(arguments),
                       // Resets the variables by which a make that runs the tests passes its
                       // options to a child make.
                       .environment = {{"PATH", programs + ":" + (path == nullptr ? "" : path)},
                                       {"MAKEFLAGS", ""},
                                       {"MFLAGS", ""},
                                       {"MAKELEVEL", "0"}},
                       .folder = folder_.path(),
                       .timeout = std::chrono::minutes(3)}
          .Run();
  REQUIRE_FALSE(result.timed_out);
  return result;
}

std::string Project::Do(const std::string& program, std::vector<std::string> arguments) const {
  const harness::CommandResult result = Run(program, std::move(arguments));
  INFO(result.out << result.err);
  REQUIRE(result.status == 0);
  return result.out;
}

void Project::Age() {
  for (const std::string& name : folder_.Files()) {
    // CMake and Ninja keep times of their own in files of their own.
    const bool ours = !name.starts_with("build-cmake/") ||
                      (name.find("CMakeFiles/") == name.npos && IsMade(name)) ||
                      // Nothing that CMake's Makefiles make may be older than this.
                      name.ends_with("/compiler_depend.ts");
    if (ours) fs::last_write_time(folder_ / name, past_);
  }
}

void Project::Touch(std::string_view name) { Change(name, "", ""); }

void Project::Change(std::string_view name, std::string_view from, std::string_view to) {
  Age();
  std::string text = folder_.Read(name);
  const std::size_t place = text.find(from);
  REQUIRE(place != text.npos);
  folder_.Write(name, text.replace(place, from.size(), to));
}

std::set<std::string> Project::Fresh(std::string_view below) const {
  std::set<std::string> fresh;
  for (const std::string& name : folder_.Files()) {
    if (!name.starts_with(below) || name.find("assets/") != name.npos ||
        name.find("CMakeFiles/") != name.npos || !IsMade(name) || name.ends_with(".d") ||
        name.find("/tray_") != name.npos) {
      continue;
    }
    if (fs::last_write_time(folder_ / name) > past_) fresh.insert(name.substr(below.size()));
  }
  return fresh;
}

}  // namespace mjforge::make
