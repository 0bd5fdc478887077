#include <catch2/catch.hpp>

#include "mjforge/diag/diag.h"

using namespace mjforge::diag;

namespace {

std::string Render(const std::string& text, SourceMark mark, bool color = false) {
  Sources sources;
  sources.Add("mug.yaml", text);
  Findings findings;
  findings.Add(Code::kSpecUnknownKey, mark, "wrong");
  return RenderText(findings[0], sources, color);
}

// The rendered line and the one with the caret, without the head.
std::string Quoted(const std::string& text, std::uint32_t column) {
  const std::string all = Render(text, {1, 1, column});
  return all.substr(all.find('\n') + 1);
}

}  // namespace

TEST_CASE("a finding shows its place, line, caret, hint and notes") {
  Sources sources;
  sources.Add("mug.yaml", "parts:\n  - {name: a, radus: 1}\n");
  sources.Add("lib.yaml", "name: b\n");
  Findings findings;
  Finding& finding = findings.Add(Code::kSpecUnknownKey, {1, 2, 15},
                                  "unknown key 'radus' in a part", "did you mean 'radius'?");
  finding.notes.push_back({{2, 1, 7}, "defined here"});
  finding.notes.push_back({{}, "no place"});
  CHECK(RenderText(findings[0], sources, false) ==
        "mug.yaml:2:15: error: unknown key 'radus' in a part [spec/unknown-key]\n"
        "  - {name: a, radus: 1}\n"
        "              ^\n"
        "  hint: did you mean 'radius'?\n"
        "lib.yaml:1:7: note: defined here\n"
        "name: b\n"
        "      ^\n"
        "mjforge: note: no place\n");
}

TEST_CASE("a finding without a place names the program") {
  CHECK(Render("x", {}) == "mjforge: error: wrong [spec/unknown-key]\n");
}

TEST_CASE("a mark of a whole file or a whole line shows as much as it says") {
  CHECK(Render("x: 1", {1, 0, 0}) == "mug.yaml: error: wrong [spec/unknown-key]\n");
  CHECK(Render("x: 1", {1, 1, 0}) == "mug.yaml:1: error: wrong [spec/unknown-key]\nx: 1\n^\n");
}

TEST_CASE("a warning says so and the variant follows the message") {
  Sources sources;
  Findings findings;
  findings.Warn(Code::kMujocoWarning, {}, "slow");
  findings.SetVariant(7, 12);
  CHECK(RenderText(findings[0], sources, false) ==
        "mjforge: warning: slow (seed 7, index 12) [mujoco/warning]\n");
}

TEST_CASE("colors: bold place, red error, yellow warning, green caret") {
  CHECK(Render("x", {1, 1, 1}, true) ==
        "\x1b[1mmug.yaml:1:1:\x1b[0m \x1b[1;31merror:\x1b[0m wrong [spec/unknown-key]\n"
        "x\n\x1b[1;32m^\x1b[0m\n");
  Sources sources;
  Findings findings;
  findings.Warn(Code::kMujocoWarning, {}, "slow");
  CHECK(RenderText(findings[0], sources, true) ==
        "\x1b[1mmjforge:\x1b[0m \x1b[1;33mwarning:\x1b[0m slow [mujoco/warning]\n");
}

TEST_CASE("the caret stands under its character") {
  CHECK(Quoted("a: b", 4) == "a: b\n   ^\n");
  SECTION("a tab takes one column") { CHECK(Quoted("a:\tb", 4) == "a: b\n   ^\n"); }
  SECTION("past the end it stands after the line") { CHECK(Quoted("a: b", 99) == "a: b\n    ^\n"); }
  SECTION("columns are bytes, the caret counts characters") {
    CHECK(Quoted("Größe: x", 10) == "Größe: x\n       ^\n");
  }
  SECTION("inside a character it stands under that character") {
    CHECK(Quoted("aöb", 3) == "aöb\n ^\n");
  }
  SECTION("a wide character takes two columns") {
    CHECK(Quoted("把手: x", 9) == "把手: x\n      ^\n");
  }
  SECTION("a combining mark takes none") { CHECK(Quoted("e\u0301: x", 6) == "e\u0301: x\n   ^\n"); }
  SECTION("an escaped character takes as many as its spelling") {
    CHECK(Quoted("a\x1b: x", 5) == "a\\x1b: x\n       ^\n");
  }
}

TEST_CASE("a blank line is not quoted") { CHECK(Quoted(" \t\n", 1).empty()); }

TEST_CASE("control characters never reach the terminal") {
  Sources sources;
  sources.Add("a\x1b[2J.yaml", "k: \x01\xff\xc2\x85\xe2\x80\xae");
  Findings findings;
  Finding& finding =
      findings.Add(Code::kYamlNotText, {1, 1, 4}, "line\nbreak \x07 \x9f", "h\x1b[0m\t");
  finding.notes.push_back({{}, "n\r"});
  CHECK(RenderText(findings[0], sources, false) ==
        "a\\x1b[2J.yaml:1:4: error: line\\nbreak \\x07 \\x9f [yaml/not-text]\n"
        "k: \\x01\\xff\\u0085\\u202e\n"
        "   ^\n"
        "  hint: h\\x1b[0m\\t\n"
        "mjforge: note: n\\r\n");
}

TEST_CASE("overlong lines are cut around the caret to 120 columns") {
  const std::string fill(500, 'x');
  const std::string fifty(50, ' ');
  SECTION("a line of 120 columns is whole") {
    CHECK(Quoted(std::string(120, 'x'), 1) == std::string(120, 'x') + "\n^\n");
  }
  SECTION("at the start") { CHECK(Quoted(fill, 1) == std::string(114, 'x') + "...\n^\n"); }
  SECTION("at the end") {
    CHECK(Quoted(fill, 500) ==
          "..." + std::string(114, 'x') + "\n" + std::string(116, ' ') + "^\n");
  }
  SECTION("in the middle") {
    const std::string line = fill + "HERE" + fill;
    const std::string text = Quoted(line, 501);
    const std::size_t end = text.find('\n');
    CHECK(end == 120);
    CHECK(text.substr(0, 4) == "...x");
    CHECK(text.substr(117, 3) == "...");
    CHECK(text.find('H') == text.find('^') - end - 1);
  }
  SECTION("a line of megabytes") {
    const std::string line = std::string(5'000'000, 'a') + "H" + std::string(5'000'000, 'b');
    const std::string text = Quoted(line, 5'000'001);
    const std::size_t end = text.find('\n');
    CHECK(end == 120);
    CHECK(text.find('H') == text.find('^') - end - 1);
  }
  SECTION("never inside a character") {
    std::string line;
    for (int i = 0; i < 3000; ++i) line += "ö";
    const std::string text = Quoted(line, 3001);
    CHECK(text.find("\\x") == std::string::npos);
  }
}
