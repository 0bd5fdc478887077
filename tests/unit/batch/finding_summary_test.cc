// Tests of grouping findings.

#include "mjforge/batch/finding_summary.h"

#include <catch2/catch.hpp>

namespace mjforge::batch {
namespace {

using diag::Code;

diag::Findings OfVariant(std::uint64_t index, diag::SourceMark mark, const std::string& message) {
  diag::Findings findings;
  findings.Add(Code::kModelBadValue, mark, message);
  findings.SetVariant(7, index);
  return findings;
}

TEST_CASE("what many variants have at one place is shown once, with a count") {
  FindingSummary finding_summary(50);
  finding_summary.Add(OfVariant(3, {1, 2, 3}, "size is -1"), false);
  finding_summary.Add(OfVariant(5, {1, 2, 3}, "size is -2"), false);
  finding_summary.Add(OfVariant(9, {1, 2, 3}, "size is -3"), false);
  const diag::Findings result = finding_summary.Findings();
  REQUIRE(result.size() == 1);
  CHECK(result[0].message == "size is -1");
  CHECK(result[0].index == 3u);
  REQUIRE(result[0].notes.size() == 1);
  CHECK(result[0].notes[0].message == "3 variants have this finding; this is the first");
}

TEST_CASE("a variant with a finding twice counts once") {
  FindingSummary finding_summary(50);
  diag::Findings findings = OfVariant(3, {1, 2, 3}, "size of 'a' is -1");
  findings.Append(OfVariant(3, {1, 2, 3}, "size of 'b' is -1"));
  finding_summary.Add(findings, false);
  REQUIRE(finding_summary.Findings().size() == 1);
  CHECK(finding_summary.Findings()[0].notes.empty());
}

TEST_CASE("findings without a place are told apart by their words") {
  FindingSummary finding_summary(50);
  finding_summary.Add(OfVariant(0, {}, "one"), false);
  finding_summary.Add(OfVariant(1, {}, "two"), false);
  CHECK(finding_summary.Findings().size() == 2);
}

TEST_CASE("findings come in file order, beyond the limit only their number") {
  FindingSummary finding_summary(2);
  finding_summary.Add(OfVariant(0, {1, 9, 1}, "late"), false);
  finding_summary.Add(OfVariant(1, {1, 2, 1}, "early"), false);
  finding_summary.Add(OfVariant(2, {1, 5, 1}, "too many"), false);
  const diag::Findings result = finding_summary.Findings();
  REQUIRE(result.size() == 2);
  CHECK(result[0].message == "early");
  CHECK(result[1].message == "late");
  CHECK(finding_summary.not_shown() == 1);
}

TEST_CASE("findings of skipped variants are warnings") {
  FindingSummary finding_summary(2);
  finding_summary.Add(OfVariant(0, {1, 9, 1}, "bad"), true);
  CHECK_FALSE(finding_summary.Findings().HasErrors());
}

}  // namespace
}  // namespace mjforge::batch
