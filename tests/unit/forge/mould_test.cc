#include "mjforge/forge/mould.h"

#include <catch2/catch.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "loaded_recipe.h"

namespace mjforge::forge {
namespace {

/// Makes the variants, none of which fails, and returns which moulds they came from.
std::vector<std::uint64_t> MouldsOf(const std::string& spec,
                                    const std::vector<std::uint64_t>& indices) {
  LoadedRecipe loaded(spec);
  Generator generator(loaded.recipe, loaded.sources, Seeded(7));
  Variant variant;
  std::vector<std::uint64_t> moulds;
  for (const std::uint64_t index : indices) {
    generator.Make(index, variant);
    REQUIRE(variant.ok());
    moulds.push_back(variant.mould);
  }
  return moulds;
}

TEST_CASE("the first variant of a kind makes a mould, and later ones come from it") {
  LoadedRecipe loaded(kBoxSpec);
  Generator generator(loaded.recipe, loaded.sources, Seeded(7));
  Variant variant;
  generator.Make(0, variant);
  CHECK(variant.mould == 0);
  generator.Make(1, variant);
  CHECK(variant.mould == 1);
  Options plain = Seeded(7);
  plain.moulds = false;
  Generator without(loaded.recipe, loaded.sources, plain);
  for (int i = 0; i < 3; ++i) {
    without.Make(1, variant);
    CHECK(variant.mould == 0);
  }
}

TEST_CASE("an object that someone still has does not change") {
  LoadedRecipe loaded(kBoxSpec);
  Generator generator(loaded.recipe, loaded.sources, Seeded(7));
  Variant first;
  generator.Make(0, first);
  const double mass = first.object->mass_properties.mass;
  Variant second;
  generator.Make(1, second);
  CHECK(second.mould == 0);
  CHECK(second.object != first.object);
  CHECK(first.object->mass_properties.mass == mass);
  CHECK(second.object->mass_properties.mass != mass);
  first = Variant();
  second = Variant();
  generator.Make(2, second);
  CHECK(second.mould > 0);
}

TEST_CASE("an object outlives the generator that made it") {
  LoadedRecipe loaded(kBoxSpec);
  Variant variant;
  {
    Generator generator(loaded.recipe, loaded.sources, Seeded(7));
    generator.Make(0, variant);
    generator.Make(1, variant);
  }
  REQUIRE(variant.object);
  CHECK(variant.object->bounds.top_offset > 0.1);
  CHECK(variant.object->mass_properties.mass > 0);
}

TEST_CASE("a name with the index in it makes no moulds") {
  LoadedRecipe loaded(kBoxSpec);
  Options options = Seeded(7);
  options.name = "crate_${index}";
  Generator generator(loaded.recipe, loaded.sources, options);
  Variant variant;
  for (std::uint64_t i = 0; i < 4; ++i) {
    generator.Make(i, variant);
    CHECK(variant.mould == 0);
    CHECK(variant.object->name == "crate_" + std::to_string(i));
  }
}

TEST_CASE("a family whose variants never go the same way stops making moulds") {
  std::vector<std::uint64_t> indices(300);
  std::iota(indices.begin(), indices.end(), 0);
  const auto moulds = MouldsOf(
      "mjforge: 1\n"
      "name: crate\n"
      "params: {n: {integer: [1, 1000000000]}}\n"
      "parts: [{name: 'p${n}', type: sphere, size: 0.1}]\n",
      indices);
  CHECK(moulds == std::vector<std::uint64_t>(300, 0));
}

TEST_CASE("moulds are tried from the one that was used last, and the oldest goes first") {
  const auto moulds = MouldsOf(
      "mjforge: 1\n"
      "name: crate\n"
      "params: {n: {cycle: [1, 2, 3]}, r: 0.1 .. 0.2}\n"
      "parts: [{name: 'p_${i}', for: {i: n}, type: sphere, size: r}]\n",
      {0, 1, 2, 3, 4, 5, 6, 6, 8});
  CHECK(moulds == std::vector<std::uint64_t>{0, 0, 0, 1, 2, 3, 1, 1, 3});
}

TEST_CASE("moulds that take too much memory together are dropped, the oldest first") {
  Moulds moulds(20'000);
  for (int i = 0; i < 3; ++i) {
    std::unique_ptr<Mould> mould = moulds.Begin();
    REQUIRE(mould);
    mjcf::MjcfDocument document;
    document.text = std::string(1'000, ' ');
    mould->Close({}, std::move(document), {});
    CHECK(mould->bytes() == 8'000);
    moulds.Add(std::move(mould));
  }
  // A mould whose object someone has is passed over.
  std::vector<Variant> variants(3);
  CHECK(moulds.Make(variants[0]));
  CHECK(variants[0].mould == 3);
  CHECK(moulds.Make(variants[1]));
  CHECK(variants[1].mould == 2);
  CHECK_FALSE(moulds.Make(variants[2]));
}

TEST_CASE("a family with a mould that takes too much memory has none") {
  LoadedRecipe loaded(kBoxSpec);
  Options options = Seeded(7);
  options.mould_bytes = 1;
  Generator generator(loaded.recipe, loaded.sources, options);
  Variant variant;
  for (std::uint64_t i = 0; i < 3; ++i) {
    generator.Make(i, variant);
    CHECK(variant.ok());
    CHECK(variant.mould == 0);
  }
}

}  // namespace
}  // namespace mjforge::forge
