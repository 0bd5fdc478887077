#include "mjforge/mjcf/provenance.h"

#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <pugixml.hpp>

namespace mjforge::mjcf {
namespace {

void CheckSame(const Provenance& a, const Provenance& b) {
  CHECK(a.version == b.version);
  CHECK(a.spec == b.spec);
  CHECK(a.spec_sha256 == b.spec_sha256);
  CHECK(a.settings == b.settings);
  CHECK(a.seed == b.seed);
  CHECK(a.index == b.index);
  CHECK(a.name == b.name);
  CHECK(a.part == b.part);
  CHECK(a.target == b.target);
  CHECK(a.assets_as == b.assets_as);
  CHECK(a.sampler == b.sampler);
  CHECK(a.batch == b.batch);
}

TEST_CASE("the opening comment says what made the file") {
  Provenance provenance;
  provenance.version = "0.1.0";
  provenance.spec = "my specs/a--b.yaml";
  provenance.spec_sha256 = "ab12";
  provenance.seed = 7;
  provenance.index = 41;
  provenance.target = "mujoco";
  provenance.settings = {{"radius", "1 .. 2"}};
  MjcfDocument out;
  AppendProvenance(provenance, out);
  CHECK(out.text ==
        "<!-- mjforge 0.1.0 spec=my%20specs/a-%2Db.yaml sha256=ab12 seed=7 index=41 target=mujoco "
        "set:radius=1%20..%202 -->");
}

TEST_CASE("the opening comment names a sampler and a batch's size where the file hangs on them") {
  Provenance provenance;
  provenance.version = "0.1.0";
  provenance.target = "mjx";
  provenance.assets_as = "files";
  provenance.sampler = "latin";
  provenance.batch = 1000;
  MjcfDocument out;
  AppendProvenance(provenance, out);
  CHECK(out.text ==
        "<!-- mjforge 0.1.0 spec= sha256= seed=0 index=0 target=mjx assets=files sampler=latin "
        "batch=1000 -->");
  CHECK_FALSE(ReadProvenance("<!-- mjforge 1 seed=1 index=2 batch=many --><mujoco/>"));
}

using namespace std::string_literals;  // keeps zero bytes

TEST_CASE("any provenance reads back from a valid comment as it was") {
  std::mt19937 random(20);
  const std::string alphabet = "ab-- =%<>&\"'\n\r\t\0\x01\x7f\xc3\xa9/:.-"s;
  const auto text = [&] {
    std::string s;
    for (auto n = random() % 12; n > 0; --n) s += alphabet[random() % alphabet.size()];
    return s;
  };
  for (int i = 0; i < 2000; ++i) {
    Provenance provenance{
        text(),       text(),   text(),  {},     random() * (std::uint64_t{1} << 32) + random(),
        std::nullopt, random(), text(),  text(), text(),
        text(),       text(),   random()};
    if (i % 2 == 0) provenance.place_seed = random();
    for (auto n = random() % 4; n > 0; --n) provenance.settings.emplace_back(text(), text());
    MjcfDocument written;
    AppendProvenance(provenance, written);
    std::string& out = written.text;
    const std::string inside = out.substr(4, out.size() - 7);
    REQUIRE(inside.find("--") == std::string::npos);
    out += "\n<mujoco/>\n";
    pugi::xml_document document;
    REQUIRE(document.load_buffer(out.data(), out.size()));
    const auto read = ReadProvenance(out);
    REQUIRE(read);
    CheckSame(*read, provenance);
  }
}

TEST_CASE("a file that mjforge did not write has no provenance") {
  CHECK_FALSE(ReadProvenance(""));
  CHECK_FALSE(ReadProvenance("not xml"));
  CHECK_FALSE(ReadProvenance("<mujoco/>"));
  CHECK_FALSE(ReadProvenance("<!-- another tool --><mujoco/>"));
  CHECK_FALSE(ReadProvenance("<mujoco><!-- mjforge 1 seed=1 index=2 --></mujoco>"));
}

TEST_CASE("a comment without seed or with a broken one is no provenance") {
  CHECK_FALSE(ReadProvenance("<!-- mjforge 0.1.0 spec=a sha256=b index=2 --><mujoco/>"));
  CHECK_FALSE(ReadProvenance("<!-- mjforge 0.1.0 seed=x index=2 --><mujoco/>"));
  CHECK_FALSE(ReadProvenance("<!-- mjforge 0.1.0 seed=1 index=2 spec=%2 --><mujoco/>"));
  CHECK_FALSE(ReadProvenance("<!-- mjforge 0.1.0 seed=1 index=2 spec=%zz --><mujoco/>"));
  CHECK(ReadProvenance("<!-- mjforge 0.1.0 seed=1 index=2 --><mujoco/>"));
}

}  // namespace
}  // namespace mjforge::mjcf
