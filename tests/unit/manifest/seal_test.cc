// Tests of seals.

#include "mjforge/manifest/seal.h"

#include <catch2/catch.hpp>

namespace mjforge::manifest {
namespace {

Seal SomeSeal() {
  Seal seal;
  seal.name = "box_${index}";
  seal.output = "x_%05d.tar";
  seal.per_archive = 10;
  seal.first = 5;
  seal.count = 40;
  seal.shard = 1;
  seal.shards = 2;
  seal.records = 20;
  seal.manifest = {"x.manifest.jsonl", {1234, "0123456789abcdef0123456789abcdef"}};
  seal.archives = {{"x_00002.tar", {99, "a"}}, {"x_00003.tar", {100, "b"}}};
  return seal;
}

TEST_CASE("a seal is read as it was written") {
  const std::string text = SealText(SomeSeal());
  CHECK(text.ends_with("\"}\n"));
  std::string why_not;
  const std::optional<Seal> seal = ReadSeal(text, why_not);
  REQUIRE(seal);
  CHECK(SealText(*seal) == text);
  CHECK(seal->archives[1].file == "x_00003.tar");
  CHECK(seal->archives[1].content.size == 100);
}

TEST_CASE("a seal with a changed bit or a missing end is refused") {
  const std::string text = SealText(SomeSeal());
  std::string why_not;
  for (std::size_t i = 0; i < text.size(); ++i) {
    INFO(i);
    CHECK_FALSE(ReadSeal(text.substr(0, i), why_not));
    for (int bit = 0; bit < 8; ++bit) {
      std::string changed = text;
      changed[i] = static_cast<char>(changed[i] ^ (1 << bit));
      CHECK_FALSE(ReadSeal(changed, why_not));
    }
  }
  CHECK_FALSE(ReadSeal(std::string(200'000, '['), why_not));
  CHECK(why_not == "it is not a seal");
  CHECK_FALSE(ReadSeal(R"({"mjforge_seal":2})", why_not));
  CHECK(why_not == "it has version 2, and this mjforge knows 1");
}

TEST_CASE("a seal with other whitespace is refused") {
  const std::string text = SealText(SomeSeal());
  std::string why_not;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    for (const char blank : {' ', '\t', '\n', '\r'}) {
      std::string changed = text;
      changed.insert(i, 1, blank);
      INFO(i);
      CHECK_FALSE(ReadSeal(changed, why_not));
    }
  }
  CHECK(why_not == "it is damaged");
}

TEST_CASE("outputs that differ say how") {
  Seal other = SomeSeal();
  CHECK(DifferenceOfOutput(SomeSeal(), other).empty());
  other.archives.clear();
  other.count = 100;
  CHECK(DifferenceOfOutput(SomeSeal(), other).empty());
  other.per_archive = 11;
  CHECK(DifferenceOfOutput(SomeSeal(), other) == "per_archive is '10', not '11'");
  CHECK(SealPathOf("out/x.manifest-00001-of-00002.jsonl") ==
        "out/x.manifest-00001-of-00002.seal.json");
  CHECK(SealPathOf("x.manifest.jsonl.zst") == "x.manifest.seal.json");
}

}  // namespace
}  // namespace mjforge::manifest
