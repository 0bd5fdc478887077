// Form of comments: a file's first sentence, and words that no sentence begins with.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cctype>

#include "house/comments.h"
#include "house/project_files.h"

namespace mjforge::house {

namespace {

// A sentence that begins with one of these has no subject, or a pronoun whose noun is elsewhere.
constexpr std::array kOpenings = {"What",     "Of",      "Those",   "That",  "As",   "So",
                                  "Where",    "How",     "Whether", "Which", "Who",  "Whose",
                                  "Else",     "It",      "They",    "One",   "Both", "The same",
                                  "The rest", "No more", "Not more"};

bool IsLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '-'; }

bool BeginsWith(std::string_view text, std::string_view opening) {
  return text.size() >= opening.size() &&
         std::ranges::equal(
             text.substr(0, opening.size()), opening,
             [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); }) &&
         (text.size() == opening.size() || !IsLetter(text[opening.size()]));
}

// Returns "file:line: sentence" for each sentence that begins with a forbidden opening.
std::vector<std::string> BadOpenings(const ProjectFile& file) {
  std::vector<std::string> places;
  for (const Sentence& sentence : ReadSentences(file.text)) {
    if (std::ranges::none_of(kOpenings, [&](std::string_view opening) {
          return BeginsWith(sentence.text, opening);
        })) {
      continue;
    }
    places.push_back(file.name + ":" + std::to_string(sentence.line) + ": " + sentence.text);
  }
  return places;
}

// Returns true if the file's first line begins a comment whose first sentence is a whole one.
bool OpensWithSentence(const ProjectFile& file) {
  if (!file.text.starts_with("// ")) return false;
  const std::string sentence = ReadSentences(file.text).front().text;
  return std::islower(static_cast<unsigned char>(sentence.front())) == 0 &&
         sentence.find(' ') != std::string::npos && sentence.ends_with('.');
}

}  // namespace

TEST_CASE("each file begins with a sentence that says what it contains") {
  bool all_do = true;
  for (const ProjectFile& file : LibraryAndProgram()) {
    if (OpensWithSentence(file)) continue;
    all_do = false;
    UNSCOPED_INFO(file.name << ":1: " << Lines(file.text).front());
  }
  CHECK(all_do);
}

TEST_CASE("no sentence of a comment begins without its subject") {
  bool none_does = true;
  for (const ProjectFile& file : LibraryAndProgram()) {
    for (const std::string& place : BadOpenings(file)) {
      none_does = false;
      UNSCOPED_INFO(place);
    }
  }
  CHECK(none_does);
}

TEST_CASE("a file's first sentence may have several lines and others behind it") {
  CHECK(OpensWithSentence({"a.h", "// Convex partition of a polygon.\n#pragma once\n"}));
  CHECK(OpensWithSentence({"a.h", "// Convex partition\n// of a polygon. Merges others.\n"}));
  CHECK(OpensWithSentence({"a.h", "// `type: prism`.\n//\n// Merges others\n"}));
  CHECK_FALSE(OpensWithSentence({"a.h", ""}));
  CHECK_FALSE(OpensWithSentence({"a.h", "\n// Convex partition of a polygon.\n"}));
  CHECK_FALSE(OpensWithSentence({"a.h", "#pragma once\n// Convex partition of a polygon.\n"}));
  CHECK_FALSE(OpensWithSentence({"a.h", "// Convex partition of a polygon\n\n// Merges.\n"}));
  CHECK_FALSE(OpensWithSentence({"a.h", "// convex partition of a polygon.\n"}));
  CHECK_FALSE(OpensWithSentence({"a.h", "// Partition.\n"}));
}

TEST_CASE("a bad opening is found in any comment, in any case, at the start of any sentence") {
  const auto places = [](const std::string& text) { return BadOpenings({"a.cc", text}); };
  using Places = std::vector<std::string>;
  CHECK(places("// What is drawn.\n") == Places{"a.cc:1: What is drawn."});
  CHECK(places("/// the same,\n/// in order\n") == Places{"a.cc:1: the same, in order"});
  CHECK(places("int a;  // as drawn\n") == Places{"a.cc:1: as drawn"});
  CHECK(places("int a;  // height\nint b;  // of the base\n") == Places{"a.cc:2: of the base"});
  CHECK(places("// Bounds, m. They\n// may be empty.\n") == Places{"a.cc:1: They may be empty."});
  CHECK(places("// Bounds\n//\n// of parts\n") == Places{"a.cc:3: of parts"});
  CHECK(places("F(\"a\", 'b', 1'000);  // how\n") == Places{"a.cc:1: how"});
  CHECK(places("a = R\"(\n)\";  // it\n") == Places{"a.cc:2: it"});
}

TEST_CASE("other openings, continued sentences and texts in quotes are not found") {
  for (const std::string text :
       {"// Bounds of a part,\n// as drawn.\n", "int a;  // bounds\n        // of a part\n",
        "// One-sided range.\n", "// Offsets.\n", "// Whatever is drawn.\n", "// The samples.\n",
        "a = \"// What\";\n", "a = \"\\\"// What\";\n", "a = '\"';  // bounds\n",
        "a = R\"(\n// What\n)\";\n", "a = R\"x(\n)\" // What\n)x\";\n", "// e.g. of a part\n"}) {
    INFO(text);
    CHECK(BadOpenings({"a.cc", text}) == std::vector<std::string>{});
  }
}

}  // namespace mjforge::house
