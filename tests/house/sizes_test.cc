// A file over its size hides a second noun: find it and give it its own file.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

constexpr std::size_t kMostLines = 400;
constexpr std::size_t kMostLinesOfHeader = 200;

// Tables may be as long as what they list.
const std::set<std::string> kTables = {"lib/mjforge/spec/fields.cc"};

constexpr std::size_t kMostLinesOfFunction = 40;

bool IsBlock(std::string_view line) {
  constexpr std::array kWords = {"if ", "for ", "while ", "switch ", "do ", "try ", "case ", "}"};
  return std::ranges::any_of(kWords, [line](std::string_view word) {
    return line.substr(line.find_first_not_of(' ')).starts_with(word);
  });
}

// Of the function whose closing brace stands alone in a line, its signature included. As
// clang-format lays out, what is in it stands further to the right. 0: it closes a block.
std::size_t LinesOfFunction(const std::vector<std::string_view>& lines, std::size_t last) {
  const std::size_t indent = lines[last].size() - 1;
  for (std::size_t first = last; first-- > 0;) {
    const std::size_t column = lines[first].find_first_not_of(' ');
    if (column == std::string_view::npos || column > indent || lines[first][0] == '#') continue;
    return column < indent || IsBlock(lines[first]) ? 0 : last - first + 1;
  }
  return 0;
}

std::size_t LongestFunction(std::string_view text) {
  const std::vector<std::string_view> lines = Lines(text);
  std::size_t longest = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == "}" || lines[i] == "  }" || lines[i] == "    }") {
      longest = std::max(longest, LinesOfFunction(lines, i));
    }
  }
  return longest;
}

}  // namespace

TEST_CASE("functions are at most 40 lines, signature and braces included") {
  for (const std::string_view folder : {"lib/", "app/"}) {
    for (const ProjectFile& file : CppFiles(folder)) {
      INFO(file.name);
      CHECK(LongestFunction(file.text) <= kMostLinesOfFunction);
    }
  }
}

TEST_CASE("a function's length is that of its text") {
  CHECK(LongestFunction("int F(int a,\n      int b) {\n\n  if (a) {\n    b;\n  }\n}\n") == 7);
  CHECK(LongestFunction("class A {\n  void F() {\n    G();\n  }\n};\n") == 3);
}

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
