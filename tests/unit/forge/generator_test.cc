#include <array>
#include <catch2/catch.hpp>
#include <map>

#include "loaded_recipe.h"

#include "mjforge/bytes/bytes.h"

namespace mjforge::forge {
namespace {

Variant MakeOne(LoadedRecipe& loaded, const Options& options, std::uint64_t index) {
  Generator generator(loaded.recipe, loaded.sources, options);
  Variant variant;
  generator.Make(index, variant);
  return variant;
}

TEST_CASE("a variant is a file's text and a record of what it is") {
  LoadedRecipe loaded(kBoxSpec);
  Options options = Seeded(7);
  options.validation = Validation::kLoad;
  const Variant variant = MakeOne(loaded, options, 42);
  const manifest::Record& record = variant.record;
  REQUIRE(variant.ok());
  CHECK(variant.findings.empty());
  CHECK(record.file == "crate_000042.xml");
  CHECK(record.name == "crate");
  CHECK(record.index == 42);
  CHECK(record.seed == 7);
  CHECK(record.spec == "crate.yaml");
  CHECK(record.spec_sha256 == loaded.recipe.spec->sha256);
  CHECK(record.target == "mujoco");
  CHECK(record.mujoco == validate::MujocoVersion());
  options.validation = Validation::kNone;
  CHECK(MakeOne(loaded, options, 42).record.mujoco.empty());
  CHECK(record.sha256 == bytes::Sha256Of(variant.document.text));
  REQUIRE(record.params.size() == 2);
  CHECK(record.params[0].first == "height");
  const double height = std::get<double>(record.params[0].second);
  CHECK(record.mass_properties.mass == Approx(500 * 0.2 * 0.2 * 2 * height));
  CHECK(record.bounds.top_offset == Approx(height));
  CHECK(record.nbody == 2);
  CHECK(record.njnt == 1);
  CHECK(record.ngeom == 2);
}

TEST_CASE("what has no value yet has none of an earlier variant's") {
  LoadedRecipe loaded(
      "mjforge: 1\n"
      "name: thing\n"
      "params: {s: 0.1 .. 0.2}\n"
      "total_size: [arm.half_x, 1, 1]\n"
      "bodies: [{name: arm, parts: [{name: a, type: box, size: [s, s, s]}]}]\n");
  Generator generator(loaded.recipe, loaded.sources, Seeded(7));
  Variant variant;
  for (std::uint64_t i = 0; i < 4; ++i) {
    generator.Make(i, variant);
    CHECK_FALSE(variant.ok());
  }
}

TEST_CASE("a variant does not depend on those made before it") {
  LoadedRecipe loaded(kBoxSpec);
  Generator generator(loaded.recipe, loaded.sources, Seeded(7));
  Variant variant;
  for (const std::uint64_t index : {5, 0, 41, 3}) generator.Make(index, variant);
  generator.Make(41, variant);
  const Variant alone = MakeOne(loaded, Seeded(7), 41);
  CHECK(variant.document.text == alone.document.text);
  std::string record;
  std::string record_alone;
  manifest::AppendRecord(record, variant.record);
  manifest::AppendRecord(record_alone, alone.record);
  CHECK(record == record_alone);
}

TEST_CASE("another seed and another index are other variants") {
  LoadedRecipe loaded(kBoxSpec);
  const auto height = [&](std::uint64_t seed, std::uint64_t index) {
    return std::get<double>(MakeOne(loaded, Seeded(seed), index).record.params[0].second);
  };
  CHECK(height(7, 0) != height(8, 0));
  CHECK(height(7, 0) != height(7, 1));
}

TEST_CASE("a name template renames the object, its file and its prefix") {
  LoadedRecipe loaded(kBoxSpec);
  Options options = Seeded(7);
  options.name = "box${index}";
  const Variant variant = MakeOne(loaded, options, 3);
  REQUIRE(variant.ok());
  CHECK(variant.record.name == "box3");
  CHECK(variant.record.file == "box3_000003.xml");
  CHECK(variant.object->name == "box3");
  CHECK(variant.document.text.find("\"box3_body\"") != std::string::npos);
}

// Returns the first index whose variant fails with this seed.
std::uint64_t FirstFailing(LoadedRecipe& loaded, std::uint64_t seed) {
  for (std::uint64_t index = 0;; ++index) {
    if (!MakeOne(loaded, Seeded(seed), index).ok()) return index;
  }
}

TEST_CASE("a variant that fails says why, with seed and index, and has no file") {
  LoadedRecipe loaded(kUnluckySpec);
  const std::uint64_t index = FirstFailing(loaded, 1);
  const Variant variant = MakeOne(loaded, Seeded(1), index);
  CHECK(variant.record.status == manifest::Status::kFailed);
  CHECK(variant.record.file.empty());
  CHECK(variant.record.sha256.empty());
  CHECK(variant.record.nbody == 0);
  REQUIRE(variant.findings.size() == 1);
  CHECK(variant.findings[0].code == diag::Code::kModelBadValue);
  CHECK(variant.findings[0].seed == 1u);
  CHECK(variant.findings[0].index == index);
  REQUIRE(variant.record.findings.size() == 1);
  // Records do not depend on the folder of the spec.
  CHECK(variant.record.findings[0].find("\"file\":\"crate.yaml\"") != std::string::npos);
}

TEST_CASE("resampling goes on with the next attempt, and replaying that attempt is the same") {
  LoadedRecipe loaded(kUnluckySpec);
  Options options = Seeded(1);
  options.on_invalid = OnInvalid::kResample;
  const std::uint64_t index = FirstFailing(loaded, 1);
  const Variant resampled = MakeOne(loaded, options, index);
  REQUIRE(resampled.ok());
  CHECK(resampled.record.attempt > 0);
  options = Seeded(1);
  options.attempt = resampled.record.attempt;
  CHECK(MakeOne(loaded, options, index).document.text == resampled.document.text);
}

TEST_CASE("resampling changes no variant that was good") {
  LoadedRecipe loaded(kUnluckySpec);
  Options resample = Seeded(1);
  resample.on_invalid = OnInvalid::kResample;
  int good = 0;
  for (std::uint64_t index = 0; index < 20; ++index) {
    const Variant plain = MakeOne(loaded, Seeded(1), index);
    if (!plain.ok()) continue;
    ++good;
    CHECK(MakeOne(loaded, resample, index).document.text == plain.document.text);
  }
  CHECK(good > 0);
}

TEST_CASE("resampling ends where every draw is bad") {
  LoadedRecipe loaded(
      "mjforge: 1\nname: crate\nparams: {height: -0.2 .. -0.1}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n");
  Options options = Seeded(1);
  options.on_invalid = OnInvalid::kResample;
  const Variant variant = MakeOne(loaded, options, 0);
  CHECK(variant.record.status == manifest::Status::kFailed);
  CHECK(variant.record.attempt == kMaxResamples);
}

TEST_CASE("resampling keeps exact choices, and an item is the same in any order") {
  const std::string text =
      std::string(kUnluckySpec)
          .replace(std::string(kUnluckySpec).find("  height"), 0,
                   "  density: {choice: [300, 500, 800], weights: [2, 1, 1], exact: true}\n");
  LoadedRecipe loaded(text);
  Options options;
  options.seed = 3;
  options.on_invalid = OnInvalid::kResample;
  options.sampler = sample::Method::kLatin;
  options.batch = 20;
  Generator forward(loaded.recipe, loaded.sources, options);
  std::vector<std::string> texts;
  std::map<double, int> counts;
  std::uint64_t redraws = 0;
  Variant variant;
  for (std::uint64_t index = 0; index < 20; ++index) {
    forward.Make(index, variant);
    REQUIRE(variant.ok());
    redraws += variant.record.attempt;
    ++counts[std::get<double>(variant.record.params[0].second)];
    texts.push_back(variant.document.text);
  }
  CHECK(redraws > 5);
  CHECK(counts == std::map<double, int>{{300, 10}, {500, 5}, {800, 5}});
  Generator backward(loaded.recipe, loaded.sources, options);
  for (std::uint64_t index = 20; index-- > 0;) {
    backward.Make(index, variant);
    CHECK(variant.document.text == texts[index]);
  }
}

TEST_CASE("welded specs are planned over the same batch") {
  LoadedRecipe loaded(
      "mjforge: 1\n"
      "name: shelf\n"
      "parts:\n"
      "  - {name: left, spec: box.yaml}\n"
      "  - {name: right, spec: box.yaml, pos: [1, 0, 0]}\n",
      {}, {{"box.yaml", kExactSpec}});
  Options options;
  options.batch = 8;
  Generator generator(loaded.recipe, loaded.sources, options);
  std::array<std::map<double, int>, 2> counts;
  Variant variant;
  for (std::uint64_t index = 0; index < 8; ++index) {
    generator.Make(index, variant);
    REQUIRE(variant.ok());
    CHECK(variant.record.batch == 8);
    CHECK(variant.record.sampler.empty());
    const auto& parts = variant.object->bodies.front().parts;
    REQUIRE(parts.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) ++counts[i][parts[i].density];
  }
  CHECK(counts[0] == std::map<double, int>{{300, 4}, {500, 2}, {800, 2}});
  CHECK(counts[1] == counts[0]);
}

TEST_CASE("a scene counts its floor") {
  LoadedRecipe loaded(kBoxSpec);
  Options options = Seeded(7);
  options.target = mjcf::Target::kScene;
  const Variant variant = MakeOne(loaded, options, 0);
  CHECK(variant.record.target == "scene");
  CHECK(variant.record.ngeom == 3);
}

}  // namespace
}  // namespace mjforge::forge
