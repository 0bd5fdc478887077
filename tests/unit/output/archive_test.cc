#include "mjforge/output/archive.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

namespace mjforge::output {
namespace {

TEST_CASE("members of several segments are read back") {
  const auto format = GENERATE(ArchiveFormat::kTar, ArchiveFormat::kTarZstd);
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  Segment segment(format);
  std::string bytes;
  REQUIRE(segment.Add("a.xml", "first", findings));
  REQUIRE(segment.Add("assets/b.png", std::string(5000, 'b'), findings));
  bytes += segment.Take();
  CHECK(segment.Take().empty());
  REQUIRE(segment.Add("empty", "", findings));
  bytes += segment.Take() + ArchiveEnd(format);
  const auto file = folder.Write("x.archive", bytes);
  CHECK(ReadMember(file, "a.xml", findings) == "first");
  CHECK(ReadMember(file, "assets/b.png", findings) == std::string(5000, 'b'));
  CHECK(ReadMember(file, "empty", findings) == "");
  CHECK(findings.empty());
}

TEST_CASE("a member that is not there, and a file that is no archive, are findings") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  Segment segment(ArchiveFormat::kTar);
  REQUIRE(segment.Add("a.xml", "first", findings));
  const auto file = folder.Write("x.tar", segment.Take() + ArchiveEnd(ArchiveFormat::kTar));
  CHECK_FALSE(ReadMember(file, "b.xml", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot read 'b.xml' in '" + file.string() + "': it is not there");
  CHECK_FALSE(ReadMember(folder.Write("y.tar", "no archive at all"), "b.xml", findings));
  CHECK_FALSE(ReadMember(folder / "none.tar", "b.xml", findings));
  CHECK(findings.size() == 3);
}

TEST_CASE("a name too long for tar is a finding, and the archive stays good") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  Segment segment(ArchiveFormat::kTar);
  REQUIRE(segment.Add("a", "1", findings));
  CHECK_FALSE(segment.Add(std::string(300, 'x'), "2", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputCannotWrite);
  REQUIRE(segment.Add("b", "3", findings));
  const auto file = folder.Write("x.tar", segment.Take() + ArchiveEnd(ArchiveFormat::kTar));
  CHECK(ReadMember(file, "b", findings) == "3");
}

}  // namespace
}  // namespace mjforge::output
