#include "both_ways.h"

#include <catch2/catch.hpp>

#include "harness/source_folder.h"

namespace mjforge::forge {
namespace {

/// What is written of the object now; it follows the text only if all its numbers do.
std::string WrittenAgain(const Variant& variant, const Recipe& recipe, const Options& options) {
  mjcf::Provenance provenance = variant.record;
  if (provenance.name == recipe.spec->name) provenance.name.clear();
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(*variant.object, options.target, provenance, document);
  diag::Findings findings;
  REQUIRE(files::Maker().Make(*variant.object, document, findings));
  return document.text;
}

}  // namespace

Loaded::Loaded(const std::filesystem::path& file) {
  diag::Findings findings;
  spec::LoadOptions options;
  options.search_path = {harness::SourceFolder() / "specs"};
  auto loaded = LoadRecipe(file, options, sources, findings);
  std::string said;
  for (const diag::Finding& finding : findings) said += finding.message + "\n";
  INFO(file << ": " << said);
  REQUIRE(loaded);
  recipe = std::move(*loaded);
}

int Compare(Loaded& loaded, Options options, std::uint64_t first, std::uint64_t count) {
  options.mould_bytes = std::size_t{1} << 30;  // so that large objects come from moulds, too
  Generator generator(loaded.recipe, loaded.sources, options);
  options.moulds = false;
  Generator plain(loaded.recipe, loaded.sources, options);
  Variant variant;
  Variant expected;
  int moulded = 0;
  for (std::uint64_t index = first; index < first + count; ++index) {
    INFO(loaded.recipe.reference << ", target " << mjcf::RulesOf(options.target).name << ", index "
                                 << index);
    generator.Make(index, variant);
    plain.Make(index, expected);
    moulded += variant.mould > 0;
    std::string line;
    std::string expected_line;
    manifest::AppendRecord(line, variant.record);
    manifest::AppendRecord(expected_line, expected.record);
    REQUIRE(line == expected_line);
    if (!expected.ok()) continue;
    REQUIRE(variant.document.text == expected.document.text);
    REQUIRE(variant.document.size_position == expected.document.size_position);
    REQUIRE(variant.document.world_position == expected.document.world_position);
    REQUIRE(variant.document.lift == expected.document.lift);
    REQUIRE(variant.document.assets == expected.document.assets);
    REQUIRE(variant.document.origins == expected.document.origins);
    REQUIRE(WrittenAgain(variant, loaded.recipe, options) == expected.document.text);
  }
  return moulded;
}

Options Seeded(std::uint64_t seed) {
  Options options;
  options.seed = seed;
  options.validation = Validation::kNone;
  return options;
}

Written::Written() {
  folder_.Write("inner.yaml",
                "mjforge: 1\n"
                "name: inner\n"
                "params: {r: 0.01 .. 0.05, long: {choice: [true, false]}, h: 3 * r,\n"
                "         what: {choice: [box, sphere]}}\n"
                "require: ['r + h < 0.17']\n"
                "joints: none\n"
                "parts:\n"
                "  - {name: a, type: sphere, size: r}\n"
                "  - {name: b, if: long, type: cylinder, size: [r, h],\n"
                "     pos: [0, 0, {uniform: [h, 2 * h]}]}\n");
}

}  // namespace mjforge::forge
