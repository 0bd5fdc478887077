#include "mjforge/diag/diag.h"

#include <catch2/catch.hpp>

using namespace mjforge::diag;

TEST_CASE("a mark gives its line without the line's end") {
  Sources sources;
  const auto file = sources.Add("a.yaml", "one\ntwo\r\n\nfour");
  CHECK(file == 1);
  CHECK(sources.Add("b.yaml", "") == 2);
  CHECK(sources.size() == 2);
  CHECK(sources.Name(2) == "b.yaml");
  CHECK(sources.Line({1, 1, 1}) == "one");
  CHECK(sources.Line({1, 2, 9}) == "two");
  CHECK(sources.Line({1, 3, 1}).empty());
  CHECK(sources.Line({1, 4, 1}) == "four");
}

TEST_CASE("of a long file a piece is enough for a mark") {
  Sources sources;
  sources.Add("a.yaml", "seven\neight", 7);
  CHECK(sources.Line({1, 7, 1}) == "seven");
  CHECK(sources.Line({1, 8, 1}) == "eight");
  CHECK(sources.Line({1, 6, 1}).empty());
  CHECK(sources.Line({1, 9, 1}).empty());
}

TEST_CASE("a safe text has no character that controls a terminal") {
  CHECK(SafeText("a\x1b[2J\n\x7f\xc2\x9b\xff") == "a\\x1b[2J\\n\\x7f\\u009b\\xff");
  CHECK(SafeLines("") == "");
  CHECK(SafeLines("a\tb\n\x1b\n\n") == "a\\tb\n\\x1b\n\n");
}

TEST_CASE("a mark without a place or past the end gives an empty line") {
  Sources sources;
  sources.Add("a.yaml", "one\n");
  CHECK(sources.Line({}).empty());
  CHECK(sources.Line({1, 0, 0}).empty());
  CHECK(sources.Line({1, 2, 1}).empty());
  CHECK(sources.Line({1, 99, 1}).empty());
  CHECK(sources.Line({2, 1, 1}).empty());
  CHECK_FALSE(static_cast<bool>(SourceMark{}));
}

TEST_CASE("a warning alone is no error") {
  Findings findings;
  CHECK(findings.empty());
  findings.Warn(Code::kMujocoWarning, {}, "slow");
  CHECK_FALSE(findings.HasErrors());
  findings.Add(Code::kSpecCycle, {}, "a -> a", "break it");
  CHECK(findings.HasErrors());
  CHECK(findings.size() == 2);
  CHECK(findings[0].severity == Severity::kWarning);
  CHECK(findings[1].severity == Severity::kError);
  CHECK(findings[1].hint == "break it");
  findings.clear();
  CHECK(findings.empty());
}

TEST_CASE("findings sort by place and keep their order at one place") {
  Findings findings;
  findings.Add(Code::kSpecCycle, {2, 1, 1}, "e");
  findings.Add(Code::kSpecCycle, {1, 3, 1}, "d");
  findings.Add(Code::kSpecCycle, {1, 2, 9}, "c");
  findings.Add(Code::kSpecCycle, {1, 2, 4}, "a");
  findings.Add(Code::kSpecBadName, {1, 2, 4}, "b");
  findings.Add(Code::kSpecBadName, {}, "first");
  findings.Sort();
  std::string order;
  for (const Finding& finding : findings) order += finding.message + " ";
  CHECK(order == "first a b c d e ");
}

TEST_CASE("repeats of a finding are dropped wherever they stand") {
  Findings findings;
  findings.Add(Code::kSpecCycle, {1, 2, 3}, "x").hint = "kept";
  findings.Add(Code::kSpecCycle, {1, 2, 3}, "y");
  findings.Add(Code::kSpecCycle, {1, 2, 3}, "x");
  findings.Add(Code::kSpecBadName, {1, 2, 3}, "x");
  findings.Add(Code::kSpecCycle, {1, 2, 4}, "x");
  findings.Unique();
  REQUIRE(findings.size() == 4);
  CHECK(findings[0].hint == "kept");
  CHECK(findings[1].message == "y");
  CHECK(findings[2].code == Code::kSpecBadName);
  CHECK(findings[3].mark == SourceMark{1, 2, 4});
}

TEST_CASE("a variant is stamped on findings that have none") {
  Findings first;
  first.Add(Code::kSampleRejected, {}, "old");
  first.SetVariant(7, 1);
  Findings second;
  second.Add(Code::kSampleRejected, {}, "new");
  first.Append(second);
  first.SetVariant(7, 2);
  CHECK(first[0].index == 1u);
  CHECK(first[1].index == 2u);
  CHECK(first[1].seed == 7u);
}
