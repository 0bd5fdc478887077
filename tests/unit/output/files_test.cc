// Tests of reading, writing and replacing files.

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;

std::string OurXml() {
  model::Object object;
  object.name = "thing";
  mjcf::Provenance provenance;
  provenance.version = "0.1.0";
  provenance.spec = "thing.yaml";
  provenance.spec_sha256 = std::string(64, 'a');
  provenance.target = "mujoco";
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, mjcf::Target::kMujoco, provenance, document);
  return document.text;
}

TEST_CASE("a file is written with exactly the bytes given, and nothing beside it") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const std::string bytes("a\0b\n", 4);
  REQUIRE(WriteFile(folder / "x.xml", bytes, false, findings));
  CHECK(folder.Read("x.xml") == bytes);
  CHECK(folder.Files() == std::vector<std::string>{"x.xml"});
  CHECK(findings.empty());
}

TEST_CASE("a file in a folder that does not exist is a finding with the system's words") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const auto file = folder / "none/x.xml";
  CHECK_FALSE(WriteFile(file, "text", false, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputCannotWrite);
  CHECK(findings[0].message == "cannot write '" + file.string() + "': No such file or directory");
}

TEST_CASE("what is written can be read back") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const std::string text(300'000, 'x');
  REQUIRE(WriteFile(folder / "big", text, false, findings));
  CHECK(ReadFile(folder / "big", text.size(), findings) == text);
}

TEST_CASE("a file that cannot be read is a finding") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const auto file = folder / "none";
  CHECK_FALSE(ReadFile(file, 1, findings).has_value());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kYamlCannotRead);
  CHECK(findings[0].message == "cannot read '" + file.string() + "': No such file or directory");
}

TEST_CASE("only a file that mjforge wrote may be replaced") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const std::string ours = OurXml();
  CHECK(MayReplace(folder / "new.xml", ours, false, findings));
  CHECK(MayReplace(folder.Write("ours.xml", ours), "<mujoco/>\n", false, findings));
  std::string flipped = ours;
  flipped[2] ^= 1;
  CHECK(MayReplace(folder.Write("flipped.xml", flipped), ours, false, findings));
  CHECK(findings.empty());

  const auto foreign = folder.Write("foreign.xml", "<mujoco/>\n");
  CHECK(MayReplace(foreign, ours, true, findings));
  CHECK_FALSE(MayReplace(foreign, ours, false, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputExists);
  CHECK(findings[0].message == "'" + foreign.string() + "' exists and was not made by mjforge");
  CHECK(findings[0].hint == "choose another place, or overwrite it with --force");
}

TEST_CASE("a damaged copy has a beginning and zeros, half of the bytes, or bytes at the end") {
  CHECK(IsDamagedCopy("", "abcdef"));
  CHECK(IsDamagedCopy("abc", "abcdef"));
  CHECK(IsDamagedCopy(std::string("ab\0\0", 4), "abcdef"));
  CHECK(IsDamagedCopy("abcxyz", "abcdef"));
  CHECK_FALSE(IsDamagedCopy("abwxyz", "abcdef"));
  CHECK_FALSE(IsDamagedCopy("abx", "abcdef"));
  CHECK(IsDamagedCopy("abcdefg", "abcdef"));
  CHECK_FALSE(IsDamagedCopy("abcdeeg", "abcdef"));
}

TEST_CASE("a file with the same bytes keeps its time where that is asked for") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const auto file = folder.Write("x.xml", "same");
  const auto old = std::filesystem::file_time_type(std::chrono::seconds(1));
  std::filesystem::last_write_time(file, old);
  REQUIRE(WriteFile(file, "same", true, findings));
  CHECK(std::filesystem::last_write_time(file) == old);
  REQUIRE(WriteFile(file, "same and more", true, findings));
  CHECK(std::filesystem::last_write_time(file) != old);
  CHECK(folder.Read("x.xml") == "same and more");
  REQUIRE(WriteFile(file, "same", true, findings));
  CHECK(folder.Read("x.xml") == "same");
}

}  // namespace
}  // namespace mjforge::output
