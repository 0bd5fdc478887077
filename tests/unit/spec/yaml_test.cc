#include <catch2/catch.hpp>

#include "loading.h"

TEST_CASE("an empty file is reported", "[yaml]") {
  const Strings expected = {
      "1:1 yaml/empty: file is empty (start with `mjforge: 1` and a `name:`)"};
  CHECK(Load("").Report() == expected);
  CHECK(Load("# only a comment\n").Report() == expected);
  CHECK(Load("---\n...\n").Report() == expected);
}

TEST_CASE("bytes that are no UTF-8 text are reported at their place", "[yaml]") {
  const std::string hint = " (a spec is a YAML file in UTF-8; is this another kind of file?)";
  CHECK(Load(std::string("a: 1\nb\0c", 8)).Report() ==
        Strings{"2:2 yaml/not-text: not UTF-8 text" + hint});
  CHECK(Load("\x7f"
             "ELF\xff\xfe")
            .Report() == Strings{"0:0 yaml/not-text: 'test.yaml' is a program, not YAML text"});
  CHECK(Load("name: \xC3\xA4\xC3").Report() == Strings{"1:9 yaml/not-text: not UTF-8 text" + hint});
}

TEST_CASE("a text over the limit is refused unread", "[yaml]") {
  const std::string text(9u << 20, '#');
  CHECK(Load(text).Report() == Strings{"1:1 yaml/too-large: file has more than 8388608 bytes "
                                       "(repeat parts with `for:`)"});
}

TEST_CASE("a duplicate key is reported at the second key, with the first", "[yaml]") {
  const Loaded loaded = LoadWithBox("name: again\n");
  REQUIRE(loaded.Report() == Strings{"4:1 yaml/duplicate-key: key 'name' appears twice"});
  CHECK(loaded.findings[0].notes.at(0).mark.line == 2);
  CHECK(loaded.spec == nullptr);
}

TEST_CASE("ten thousand brackets are too deep, not a crash", "[yaml]") {
  CHECK(Load("a: " + std::string(10'000, '[')).Report() ==
        Strings{"1:204 yaml/too-deep: nested too deeply"});
  CHECK(Load("a: " + std::string(10'000, '[') + std::string(10'000, ']')).Report() ==
        Strings{"1:204 yaml/too-deep: nested too deeply"});
  std::string block;
  for (int i = 0; i < 2'000; ++i) block += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  const Strings report = Load(block).Report();
  REQUIRE(report.size() == 1);
  CHECK(report[0].find("yaml/too-deep: nested too deeply") != std::string::npos);
}

TEST_CASE("an alias inside its own anchor is reported at the alias", "[yaml]") {
  CHECK(Load("a: &x [1, *x]\n").Report() ==
        Strings{"1:11 yaml/alias: alias is inside its own anchor"});
}

TEST_CASE("an alias bomb is cut off", "[yaml]") {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 20; ++i) {
    const std::string previous = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + previous;
    for (int k = 0; k < 9; ++k) text += ", " + previous;
    text += "]\n";
  }
  const Strings report = Load(text).Report();
  REQUIRE(report.size() == 1);
  CHECK(report[0].find("yaml/alias: aliases repeat more than 100000 nodes") != std::string::npos);
}

TEST_CASE("an alias carries its own place", "[yaml]") {
  CHECK(ReportWithBox("params: {a: &v {bernoulli: 0.5}}\nrequire: *v\n") ==
        Strings{"5:10 spec/wrong-type: expected a list of conditions, got a mapping"});
}

TEST_CASE("an empty value is reported at its key", "[yaml]") {
  CHECK(ReportWithBox("params:\n  r:\n  h: 1\n") ==
        Strings{"5:3 spec/wrong-type: expected a value, got nothing"});
}

TEST_CASE("a tag is reported, a leading '!' with its mending", "[yaml]") {
  CHECK(ReportWithBox("params: {b: true, c: !b}\n").at(0) ==
        "4:22 yaml/tag: tag '!b' has no meaning here (to negate, write `not b` or quote the "
        "expression)");
}

TEST_CASE("a second document is refused", "[yaml]") {
  CHECK(Load("mjforge: 1\n---\nname: x\n").Report() ==
        Strings{"1:1 yaml/syntax: file holds more than one document (write one spec per file)"});
}

TEST_CASE("broken syntax is reported at its place", "[yaml]") {
  CHECK(Load("mjforge: 1\nparts: [1, 2\nname: x\n").Report().size() == 1);
  CHECK(
      Load("a: b: c\n").Report() ==
      Strings{
          "1:5 yaml/syntax: a colon where no key is allowed (quote the text if it contains ': ')"});
}

TEST_CASE("text with an expression in braces has the quotes that it needs in the hint", "[yaml]") {
  const auto report = [](const std::string& text) { return Load(text).Report().at(0); };
  const std::string say = "in braces or brackets a value with '${...}' needs quotes";
  CHECK(report("parts:\n  - {name: ball_${i}, type: box}\n") ==
        "2:18 yaml/syntax: " + say + " (write 'ball_${i}', or put it on a line of its own)");
  CHECK(report("parts:\n  - {name: ${a}_${b}_c, type: box}\n") ==
        "2:13 yaml/syntax: " + say + " (write '${a}_${b}_c', or put it on a line of its own)");
  CHECK(report("parts:\n  - {name: ${c ? 'a' : 'b'}, type: box}\n") ==
        "2:13 yaml/syntax: " + say + " (write \"${c ? 'a' : 'b'}\")");
  CHECK(report("parts:\n  - {name: ${c ? 'a' : \"b\"}, type: box}\n") ==
        "2:13 yaml/syntax: " + say + " (write '${c ? ''a'' : \"b\"}')");
  CHECK(report("parts:\n  - {name: ${c\n     ? 'a' : 'b'}, type: box}\n") ==
        "2:13 yaml/syntax: " + say + " (put quotes around the whole value)");
}

TEST_CASE("a choice in text on a line of its own needs quotes, too", "[yaml]") {
  CHECK(Load("parts:\n  - name: left ${c ? 'a' : 'b'}\n").Report() ==
        Strings{"2:26 yaml/syntax: a value with ': ' in '${...}' needs quotes (write \"left ${c ? "
                "'a' : 'b'}\")"});
  CHECK(Load("words:\n  - ${c ? 'a' : 'b'}\n").Report() ==
        Strings{"2:20 yaml/syntax: a value with ': ' in '${...}' needs quotes (write \"${c ? 'a' : "
                "'b'}\")"});
}

TEST_CASE("a choice in brackets needs quotes", "[yaml]") {
  CHECK(Load("size: [c ? 1 : 2, 5cm]\n").Report() ==
        Strings{"1:10 yaml/syntax: '[' without ']', or a comma is missing (in braces or brackets a "
                "choice is quoted: [\"wide ? 2cm : 1cm\", 0, 0])"});
}
