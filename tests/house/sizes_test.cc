// A file over its size hides a second noun: find it and give it its own file.

#include <catch2/catch.hpp>
#include <set>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

constexpr std::size_t kMostLines = 400;
constexpr std::size_t kMostLinesOfHeader = 200;

// Tables may be as long as what they list.
const std::set<std::string> kTables = {"lib/mjforge/spec/fields.cc"};

}  // namespace

TEST_CASE("files of C++ are at most 400 lines, headers 200") {
  std::size_t count = 0;
  for (const std::string_view folder : {"lib/", "app/", "tests/", "bench/"}) {
    for (const ProjectFile& file : CppFiles(folder)) {
      ++count;
      if (kTables.contains(file.name)) continue;
      INFO(file.name);
      CHECK(Lines(file.text).size() <=
            (file.name.ends_with(".h") ? kMostLinesOfHeader : kMostLines));
    }
  }
  CHECK(count > 50);
}

TEST_CASE("app/main.cc is at most 60 lines") {
  const std::vector<ProjectFile> files = CppFiles("app/main.cc");
  REQUIRE(files.size() == 1);
  CHECK(Lines(files[0].text).size() <= 60);
}

TEST_CASE("no file is a drawer") {
  for (const ProjectFile& file : ProjectFiles()) {
    for (const std::string word : {"util", "helper", "common", "misc"}) {
      INFO(file.name);
      CHECK(file.name.find(word) == std::string::npos);
    }
  }
}

}  // namespace mjforge::house
