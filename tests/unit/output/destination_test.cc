// Tests of parsing destinations and naming files.

#include "mjforge/output/destination.h"

#include <catch2/catch.hpp>

namespace mjforge::output {
namespace {

using Kind = Destination::Kind;

std::optional<Destination> Parse(std::string_view text) {
  std::string why_not;
  return ParseDestination(text, 100, why_not);
}

TEST_CASE("the output's ending says what it is") {
  CHECK(Parse("-")->kind == Kind::kStandardOutput);
  CHECK(Parse("a/x.xml")->kind == Kind::kFile);
  CHECK(Parse("a/out")->kind == Kind::kFolder);
  CHECK(Parse("")->kind == Kind::kFolder);
  CHECK(Parse("50%_off/")->kind == Kind::kFolder);
  CHECK(Parse("a/x.tar")->kind == Kind::kArchive);
  CHECK(Parse("a/x.tar")->format == ArchiveFormat::kTar);
  CHECK(Parse("a/x.tar.zst")->format == ArchiveFormat::kTarZstd);
  CHECK(Parse("a/x_%05d.tar")->kind == Kind::kArchives);
  CHECK(Parse("a/x_%05d.tar")->per_archive == 100);
  CHECK(Parse("a/x_%05d.tar.zst")->format == ArchiveFormat::kTarZstd);
}

TEST_CASE("other archives and odd patterns are refused") {
  for (const char* text : {"x.zst", "x.tar.gz", "x.tgz", "x.zip", "x_%s.tar", "x_%.tar",
                           "x_%d_%d.tar", "%d/x_%d.tar", "100%/x.tar", "x_%99d.tar"}) {
    INFO(text);
    std::string why_not;
    CHECK_FALSE(ParseDestination(text, 100, why_not));
    CHECK_FALSE(why_not.empty());
  }
}

TEST_CASE("archives of a series are numbered as the pattern says") {
  CHECK(Parse("a/x_%05d.tar")->Archive(42) == "a/x_00042.tar");
  CHECK(Parse("a/%d-x.tar")->Archive(42) == "a/42-x.tar");
  CHECK(Parse("a/x_%03d.tar.zst")->Archive(12345) == "a/x_12345.tar.zst");
  CHECK(Parse("a/x.tar")->Archive(0) == "a/x.tar");
}

TEST_CASE("the manifest is in the folder, or beside the archives") {
  CHECK(Parse("out/")->Manifest({}) == "out/manifest.jsonl");
  CHECK(Parse("out")->Manifest({3, 8}) == "out/manifest-00003-of-00008.jsonl");
  CHECK(Parse("a/x.tar")->Manifest({}) == "a/x.manifest.jsonl");
  CHECK(Parse("x_%05d.tar.zst")->Manifest({}) == "x.manifest.jsonl.zst");
  CHECK(Parse("x_%05d.tar.zst")->Manifest({3, 8}) == "x.manifest-00003-of-00008.jsonl.zst");
  CHECK(Parse("a/x-%d.tar")->Manifest({0, 2}) == "a/x.manifest-00000-of-00002.jsonl");
  CHECK(Parse("a/%d.tar")->Manifest({}) == "a/manifest.jsonl");
}

TEST_CASE("the place of a variant's file depends on its index alone") {
  CHECK(VariantStem("hammer", 42) == "hammer_000042");
  CHECK(VariantStem("hammer", 12'345'678) == "hammer_12345678");
  CHECK(PathInFolder("hammer", 0) == "hammer_000000.xml");
  CHECK(PathInFolder("hammer", 9'999) == "hammer_009999.xml");
  CHECK(PathInFolder("hammer", 10'000) == "0010000/hammer_010000.xml");
  CHECK(PathInFolder("hammer", 123'456'789) == "123450000/hammer_123456789.xml");
}

}  // namespace
}  // namespace mjforge::output
