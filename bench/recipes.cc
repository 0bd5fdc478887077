// Specs for benchmarks, and generation of the MJCF text of one variant.

#include "recipes.h"

#include <cstdlib>

#include <fmt/format.h>

namespace mjforge::bench {
namespace {

[[noreturn]] void Quit(const diag::Findings& findings, const diag::Sources& sources) {
  for (const diag::Finding& finding : findings) {
    fmt::print(stderr, "{}", diag::RenderText(finding, sources, false));
  }
  std::exit(1);
}

}  // namespace

LoadedRecipe& Hammer() {
  static auto* const kHammer = new LoadedRecipe(Named("robosuite/hammer", {}));
  return *kHammer;
}

LoadedRecipe Named(const std::string& reference, const std::vector<spec::Setting>& settings) {
  LoadedRecipe loaded;
  diag::Findings findings;
  auto recipe = forge::LoadRecipe(
      reference, {.settings = settings, .parameter_files = {}, .search_path = forge::SearchPath()},
      loaded.sources, findings);
  if (!recipe) Quit(findings, loaded.sources);
  loaded.recipe = std::move(*recipe);
  return loaded;
}

LoadedRecipe Row(int parts) {
  const std::string yaml = fmt::format(
      "mjforge: 1\n"
      "name: row\n"
      "params: {{n: {}, step: 2cm .. 3cm}}\n"
      "parts:\n"
      "  - name: box_${{i}}\n"
      "    for: {{i: n}}\n"
      "    type: box\n"
      "    size: [1cm .. 2cm, 0.4 * step, 1cm]\n"
      "    pos: [i * step, 0, 0]\n"
      "    density: 500\n",
      parts);
  return FromText(yaml);
}

LoadedRecipe FromText(const std::string& yaml) {
  LoadedRecipe loaded;
  diag::Findings findings;
  loaded.recipe.spec = spec::LoadSpecText("bench.yaml", yaml, ".", {}, loaded.sources, findings);
  if (loaded.recipe.spec == nullptr) Quit(findings, loaded.sources);
  loaded.recipe.reference = "bench";
  return loaded;
}

void MakeText(const forge::Recipe& recipe, assemble::Assembler& assembler, std::uint64_t index,
              mjcf::MjcfDocument& document) {
  diag::Findings findings;
  auto values =
      sample::Sample(*recipe.spec, {.seed = 7, .index = index}, sample::kRootStream, {}, findings);
  const auto object = assembler.Assemble(*values, {}, findings);
  if (!object) std::abort();
  mjcf::Provenance provenance;
  provenance.seed = 7;
  provenance.index = index;
  mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, provenance, document);
}

}  // namespace mjforge::bench
