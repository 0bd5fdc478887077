// What no file of the project may say.

#include <catch2/catch.hpp>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

// Where `word` stands: "file:line: text"; nothing if nowhere.
std::vector<std::string> PlacesOf(const std::vector<ProjectFile>& files, std::string_view word) {
  std::vector<std::string> places;
  for (const ProjectFile& file : files) {
    if (file.text.find(word) == std::string::npos) continue;
    const std::vector<std::string_view> lines = Lines(file.text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].find(word) == std::string_view::npos) continue;
      places.push_back(file.name + ":" + std::to_string(i + 1) + ": " +
                       std::string(lines[i].substr(0, 200)));
    }
  }
  return places;
}

// Files without a zero byte. Four letters can occur by chance in a picture.
std::vector<ProjectFile> TextFiles() {
  std::vector<ProjectFile> files = ProjectFiles();
  std::erase_if(files,
                [](const ProjectFile& file) { return file.text.find('\0') != file.text.npos; });
  return files;
}

}  // namespace

TEST_CASE("no file names a folder of one machine") {
  // In pieces, so that this file does not name them.
  for (const std::string name : {"home", "root", "work", "Users"}) {
    CHECK(PlacesOf(ProjectFiles(), "/" + name + "/") == std::vector<std::string>{});
  }
}

TEST_CASE("no file is left unfinished") {
  for (const std::string second_half : {"DO", "ME"}) {
    const std::string word = (second_half == "DO" ? "TO" : "FIX") + second_half;
    CHECK(PlacesOf(TextFiles(), word) == std::vector<std::string>{});
  }
}

TEST_CASE("a forbidden word is found where it stands") {
  const std::vector<ProjectFile> files = {{"a.cc", "one\ntwo\n"}, {"b.cc", "two"}};
  CHECK(PlacesOf(files, "two") == std::vector<std::string>{"a.cc:2: two", "b.cc:1: two"});
}

TEST_CASE("text files have Unix line ends and end with one") {
  for (const ProjectFile& file : ProjectFiles()) {
    if (!file.name.ends_with(".cc") && !file.name.ends_with(".h") &&
        !file.name.ends_with(".cmake") && !file.name.ends_with(".md")) {
      continue;
    }
    INFO(file.name);
    CHECK(file.text.find('\r') == std::string::npos);
    CHECK(file.text.ends_with('\n'));
    CHECK_FALSE(file.text.ends_with("\n\n"));
  }
}

}  // namespace mjforge::house
