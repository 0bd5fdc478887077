// Comparison of variants that are made in several orders and by several generators.

#include "purity.h"

#include <map>

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "harness/quick_settings.h"
#include "harness/source_folder.h"

namespace mjforge::forge {
namespace {

std::string LineOf(const Variant& variant) {
  std::string line;
  manifest::AppendRecord(line, variant.record);
  return line;
}

void CheckSame(const Variant& variant, const Variant& expected) {
  INFO("index " << expected.record.index);
  REQUIRE(LineOf(variant) == LineOf(expected));
  if (!expected.ok()) return;
  REQUIRE(variant.document.text == expected.document.text);
  REQUIRE(variant.document.size_position == expected.document.size_position);
  REQUIRE(variant.document.world_position == expected.document.world_position);
  REQUIRE(variant.document.lift == expected.document.lift);
  REQUIRE(variant.document.assets == expected.document.assets);
  // Files that are attached have new numbers in each generator.
  REQUIRE(std::ranges::equal(variant.document.origins, expected.document.origins,
                             [](const mjcf::LineOrigin& a, const mjcf::LineOrigin& b) {
                               return a.line == b.line && a.mark.line == b.mark.line &&
                                      a.mark.column == b.mark.column;
                             }));
}

}  // namespace

Loaded::Loaded(const std::filesystem::path& file) {
  diag::Findings findings;
  spec::LoadOptions options;
  options.search_path = {harness::SourceFolder() / "specs"};
  for (const auto& [name, value] : harness::QuickSettings(file.string()))
    options.settings.push_back({.name = name, .text = value});
  auto loaded = LoadRecipe(file, options, sources, findings);
  std::string messages;
  for (const diag::Finding& finding : findings) messages += finding.message + "\n";
  INFO(file << ": " << messages);
  REQUIRE(loaded);
  recipe = std::move(*loaded);
}

int ComparePure(Loaded& loaded, const Options& options, std::uint64_t first, std::uint64_t count) {
  constexpr std::uint64_t kAlone = 7;  // every seventh variant is made alone
  INFO(loaded.recipe.reference << ", target " << mjcf::RulesOf(options.target).name);
  int valid = 0;
  Generator backwards(loaded.recipe, loaded.sources, options);
  std::map<std::uint64_t, Variant> kept;
  for (std::uint64_t i = count; i-- > 0;) {
    Variant& variant = kept[first + i];
    backwards.Make(first + i, variant);
    valid += variant.ok() ? 1 : 0;
  }
  Generator in_order(loaded.recipe, loaded.sources, options);
  Variant reused;
  for (const auto& [index, expected] : kept) {
    in_order.Make(index, reused);
    CheckSame(reused, expected);
    if (index % kAlone != 0) continue;
    Variant alone;
    Generator(loaded.recipe, loaded.sources, options).Make(index, alone);
    CheckSame(alone, expected);
  }
  return valid;
}

Options Seeded(std::uint64_t seed) {
  Options options;
  options.seed = seed;
  options.validation = Validation::kNone;
  return options;
}

SpecFolder::SpecFolder() {
  folder_.Write("tetrahedron.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                "f 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n");
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

std::vector<std::filesystem::path> BundledSpecs() {
  const std::filesystem::path folder = harness::SourceFolder() / "specs";
  std::vector<std::filesystem::path> specs;
  for (const std::string& name : spec::ListSpecs(folder))
    specs.push_back(folder / (name + ".yaml"));
  REQUIRE(specs.size() > 15);
  return specs;
}

int CasesOf(const std::filesystem::path& spec, int whole) {
  return spec.parent_path().filename() == "scenes" ? 1 : harness::Effort(whole);
}

}  // namespace mjforge::forge
