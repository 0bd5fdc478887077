// Lists of CONTRIBUTING.md: the files that must change when a part type, a distribution, a target
// or a finding is added.

#include <algorithm>
#include <catch2/catch.hpp>
#include <iterator>
#include <regex>
#include <set>

#include "house/project_files.h"

namespace mjforge::house {

namespace {

using NameSet = std::set<std::string>;

// Returns what the first group of `pattern` matches, all over `text`.
NameSet FindAll(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  NameSet found;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match) {
    found.insert((*match)[1]);
  }
  return found;
}

const std::string& TextOf(std::string_view name) {
  const auto file = std::ranges::find(ProjectFiles(), name, &ProjectFile::name);
  REQUIRE(file != ProjectFiles().end());
  return file->text;
}

bool Exists(const std::string& name) {
  // A star stands for any part of a name. A folder exists if a file does in it.
  std::string pattern = std::regex_replace(name, std::regex("[.]"), "[.]");
  pattern = std::regex_replace(pattern, std::regex("[*]"), "[^/]*");
  const std::regex regex("(lib/mjforge/)?" + pattern + (name.ends_with('/') ? ".*" : "(/.*)?"));
  return std::ranges::any_of(
      ProjectFiles(), [&](const ProjectFile& file) { return std::regex_match(file.name, regex); });
}

// Returns the names for which a name with words in braces stands: a/{b,c}.h is a/b.h and a/c.h.
NameSet Expanded(const std::string& name) {
  const std::size_t open = name.find('{');
  if (open == std::string::npos) return {name};
  const std::size_t close = name.find('}', open);
  NameSet names;
  for (const std::string& word : FindAll(name.substr(open + 1, close - open - 1), "([^,]+)")) {
    names.insert(name.substr(0, open) + word + name.substr(close + 1));
  }
  return names;
}

// Returns the files and folders that a text names in backquotes.
NameSet FilesIn(const std::string& text) {
  NameSet files;
  for (const std::string& name : FindAll(
           text,
           "`((?:tests|specs|docs|schemas|app)/[^`<>]*|[^` <>]+[.](?:h|cc|inc|md|json|cmake))`")) {
    files.merge(Expanded(name));
  }
  return files;
}

std::string Chapter(const std::string& heading) {
  const std::string& text = TextOf("CONTRIBUTING.md");
  const std::size_t begin = text.find("\n## " + heading + "\n");
  REQUIRE(begin != std::string::npos);
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

// Returns the words that `pattern` finds in the one file that has `place`.
NameSet WordsAt(const std::string& place, const std::string& pattern) {
  for (const ProjectFile& file : LibraryAndProgram()) {
    const std::size_t begin = file.text.find(place);
    if (begin == std::string::npos) continue;
    return FindAll(file.text.substr(begin, file.text.find("};", begin) - begin), pattern);
  }
  FAIL("nothing has " << place);
  return {};
}

NameSet Enumerators(const std::string& enumeration) {
  return WordsAt("enum class " + enumeration + " {", "\\b(k[A-Z]\\w*)");
}

// Returns true if the text has a table: at least half of all words between `before` and `after`.
bool HasHalf(const std::string& text, const NameSet& words, const std::string& before,
             const std::string& after = "") {
  const auto has = [&](const std::string& word) {
    return text.find(before + word + after) != std::string::npos;
  };
  return 2 * std::ranges::count_if(words, has) >= std::ssize(words);
}

// Returns true if the text has a switch over the enumeration or a table of it.
bool HasEnumeration(const std::string& text, const std::string& enumeration) {
  if (text.find(enumeration + "::k") == std::string::npos) return false;
  return !FindAll(text, "\\bcase (?:\\w+::)*(" + enumeration + ")::k").empty() ||
         HasHalf(text, Enumerators(enumeration), enumeration + "::");
}

template <typename Predicate>
void CheckList(const std::string& heading, Predicate must_be_named) {
  const NameSet named = FilesIn(Chapter(heading));
  std::size_t count = 0;
  for (const ProjectFile& file : LibraryAndProgram()) {
    if (!must_be_named(file.text)) continue;
    ++count;
    const std::string name = std::regex_replace(file.name, std::regex("^lib/mjforge/"), "");
    INFO("CONTRIBUTING.md, " << heading << ": " << name);
    CHECK(named.contains(name));
  }
  CHECK(count > 0);
}

}  // namespace

TEST_CASE("each file that CONTRIBUTING.md names exists") {
  const NameSet files = FilesIn(TextOf("CONTRIBUTING.md"));
  CHECK(files.size() > 30);
  for (const std::string& file : files) {
    INFO(file);
    CHECK(Exists(file));
  }
}

TEST_CASE("the list for part types names each file with a switch or a table of them") {
  const NameSet types = WordsAt("ShapeInfo{\"", "ShapeInfo[{]\"(\\w+)\"");
  REQUIRE(types.size() >= 10);
  const NameSet solids = WordsAt("using SolidShape = std::variant<", "\\b([A-Z]\\w+)[,>]");
  REQUIRE(solids.size() >= 6);
  CheckList("Adding a part type", [&](const std::string& text) {
    return HasEnumeration(text, "GeomType") || HasHalf(text, types, "\"", "\"") ||
           HasHalf(text, solids, "solid::") || HasHalf(text, solids, "struct ") ||
           text.find("mjGEOM_ELLIPSOID") != std::string::npos;
  });
}

TEST_CASE("the list for distributions names each file with a switch or a table of them") {
  CheckList("Adding a distribution",
            [](const std::string& text) { return HasEnumeration(text, "Distribution"); });
}

TEST_CASE("the list for targets names each file with a switch or a table of them") {
  CheckList("Adding a target",
            [](const std::string& text) { return HasEnumeration(text, "Target"); });
}

TEST_CASE("no code of a finding is decided on in a switch") {
  for (const ProjectFile& file : LibraryAndProgram()) {
    INFO(file.name);
    CHECK(file.text.find("case Code::k") == std::string::npos);
    CHECK(file.text.find("case diag::Code::k") == std::string::npos);
  }
}

TEST_CASE("a switch is one with any case, a table has half of the enumerators") {
  CHECK(HasEnumeration("  case GeomType::kBox:\n", "GeomType"));
  CHECK(HasEnumeration("  case model::GeomType::kBox:\n", "GeomType"));
  CHECK(HasEnumeration("GeomType::kBox GeomType::kSphere GeomType::kMesh", "GeomType"));
  CHECK_FALSE(HasEnumeration("GeomType::kBox GeomType::kBox GeomType::kMesh", "GeomType"));
  CHECK_FALSE(HasEnumeration("  case OtherGeomType::kBox:\n", "GeomType"));
}

TEST_CASE("files are those in backquotes, with braces expanded") {
  CHECK(FilesIn("in `a/b.h`, c.cc and `tests/{d,e}_test.cc`; `specs/new/` and `stage/code`") ==
        NameSet{"a/b.h", "specs/new/", "tests/d_test.cc", "tests/e_test.cc"});
}

}  // namespace mjforge::house
