// Tests of writing and reading archives.

#include "mjforge/output/archive.h"

#include <catch2/catch.hpp>
#include <cstdio>

#include "mjforge/bytes/bytes.h"

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
  bytes += segment.Bytes();
  segment.Clear();
  CHECK(segment.Bytes().empty());
  REQUIRE(segment.Add("empty", "", findings));
  bytes += std::string(segment.Bytes()) + ArchiveEnd(format);
  const auto file = folder.Write("x.archive", bytes);
  CHECK(ReadMember(file, "a.xml", findings) == "first");
  CHECK(ReadMember(file, "assets/b.png", findings) == std::string(5000, 'b'));
  CHECK(ReadMember(file, "empty", findings) == "");
  CHECK(findings.empty());

  ArchiveReader reader(file);
  std::string why_not;
  CHECK(reader.Next(why_not) == "a.xml");
  CHECK(reader.Next(why_not) == "assets/b.png");
  CHECK(reader.Content(why_not) == std::string(5000, 'b'));
  CHECK(reader.Next(why_not) == "empty");
  CHECK(reader.Content(why_not) == "");
  CHECK_FALSE(reader.Next(why_not));
  CHECK(why_not.empty());
}

TEST_CASE("an archive that ends in the middle of a member cannot be read to its end") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  Segment segment(ArchiveFormat::kTar);
  REQUIRE(segment.Add("a.xml", std::string(5000, 'a'), findings));
  ArchiveReader reader(folder.Write("x.tar", std::string(segment.Bytes()).substr(0, 2000)));
  std::string why_not;
  CHECK(reader.Next(why_not) == "a.xml");
  CHECK_FALSE(reader.Content(why_not));
  CHECK_FALSE(why_not.empty());
}

TEST_CASE("a member that is not there, and a file that is no archive, are findings") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  Segment segment(ArchiveFormat::kTar);
  REQUIRE(segment.Add("a.xml", "first", findings));
  const auto file =
      folder.Write("x.tar", std::string(segment.Bytes()) + ArchiveEnd(ArchiveFormat::kTar));
  CHECK_FALSE(ReadMember(file, "b.xml", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot read 'b.xml' in '" + file.string() + "': it is not there");
  CHECK_FALSE(ReadMember(folder.Write("y.tar", "no archive at all"), "b.xml", findings));
  CHECK_FALSE(ReadMember(folder / "none.tar", "b.xml", findings));
  CHECK(findings.size() == 3);
}

TEST_CASE("an archive is recognized by its first object") {
  const auto format = GENERATE(ArchiveFormat::kTar, ArchiveFormat::kTarZstd);
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  const auto archive_of = [&](const std::vector<std::pair<std::string, std::string>>& members) {
    Segment segment(format);
    for (const auto& [name, bytes] : members) REQUIRE(segment.Add(name, bytes, findings));
    return std::string(segment.Bytes()) + ArchiveEnd(format);
  };
  const auto is_ours = [&](const std::string& bytes) {
    return IsObjectArchive(folder.Write("x", bytes));
  };
  const std::string object = "<!-- mjforge 0.1.0 spec=a.yaml seed=1 index=0 -->\n<mujoco/>\n";
  CHECK(is_ours(archive_of({{"a.xml", object}, {"b", "x"}})));
  CHECK(is_ours(archive_of({{"assets/b.png", std::string(5000, 'b')}, {"a.xml", object}})));
  CHECK(is_ours(archive_of({})));
  CHECK(is_ours(""));
  CHECK(is_ours(std::string(5000, '\0')));
  const std::string whole = archive_of({{"a.xml", object + std::string(100'000, ' ')}});
  if (format == ArchiveFormat::kTar) CHECK(is_ours(whole.substr(0, whole.size() / 2)));
  CHECK_FALSE(is_ours(archive_of({{"a.xml", "<mujoco/>\n"}})));
  CHECK_FALSE(is_ours(archive_of({{"notes", "x"}, {"a.xml", object}})));
  CHECK_FALSE(is_ours(archive_of({{"assets/b.png", "b"}})));
  CHECK_FALSE(is_ours("mine"));
  CHECK_FALSE(IsObjectArchive(folder.path()));
}

// Returns a tar header (POSIX, pax, "ustar Interchange Format") for a file of any claimed size.
std::string HeaderOf(const std::string& name, char type, std::uint64_t size) {
  std::string header(512, '\0');
  const auto put = [&](std::size_t at, const std::string& text) {
    header.replace(at, text.size(), text);
  };
  put(0, name);
  put(100, "0000644");
  char octal[13];
  std::snprintf(octal, sizeof(octal), "%011llo", static_cast<unsigned long long>(size));
  put(124, octal);
  put(148, std::string(8, ' '));
  put(156, std::string(1, type));
  put(257, std::string("ustar\0"
                       "00",
                       8));
  unsigned sum = 0;
  for (const char c : header) sum += static_cast<unsigned char>(c);
  std::snprintf(octal, sizeof(octal), "%06o", sum);
  put(148, std::string(octal) + '\0');
  return header;
}

TEST_CASE("a member that says it is larger than an object may be is not read") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  // 8 GiB less one byte is the largest size that this header can express.
  const auto file = folder.Write("x.tar", HeaderOf("a.xml", '0', 0x1FFFFFFFF) + "few bytes");
  CHECK_FALSE(ReadMember(file, "a.xml", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot read 'a.xml' in '" + file.string() +
                                   "': it has 8589934591 bytes, more than 268435456");
}

TEST_CASE("a member whose name this locale cannot spell is passed over") {
  const harness::TemporaryFolder folder;
  diag::Findings findings;
  const std::string name = "15 path=\xC3\xA4.xml\n";
  std::string bytes = HeaderOf("pax", 'x', name.size()) + name;
  bytes.resize(1024);
  Segment segment(ArchiveFormat::kTar);
  REQUIRE(segment.Add("b.xml", "good", findings));
  const auto file =
      folder.Write("x.tar", bytes + HeaderOf("a.xml", '0', 0) + std::string(segment.Bytes()) +
                                ArchiveEnd(ArchiveFormat::kTar));
  CHECK(ReadMember(file, "b.xml", findings) == "good");
}

TEST_CASE("what is no regular file is not read as an archive") {
  diag::Findings findings;
  CHECK_FALSE(ReadMember("/dev/zero", "a.xml", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot read 'a.xml' in '/dev/zero': it is a device");
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
  const auto file =
      folder.Write("x.tar", std::string(segment.Bytes()) + ArchiveEnd(ArchiveFormat::kTar));
  CHECK(ReadMember(file, "b", findings) == "3");
}

}  // namespace
}  // namespace mjforge::output
