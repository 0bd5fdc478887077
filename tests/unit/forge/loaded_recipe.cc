#include "loaded_recipe.h"

#include <catch2/catch.hpp>

namespace mjforge::forge {

LoadedRecipe::LoadedRecipe(const std::string& text, spec::LoadOptions options,
                           const std::vector<std::pair<std::string, std::string>>& beside) {
  for (const auto& [name, content] : beside) folder.Write(name, content);
  diag::Findings findings;
  const std::string file = folder.Write("crate.yaml", text).string();
  std::optional<Recipe> loaded = LoadRecipe(file, options, sources, findings);
  for (const diag::Finding& finding : findings) {
    UNSCOPED_INFO(diag::RenderText(finding, sources, false));
  }
  REQUIRE(loaded);
  recipe = *std::move(loaded);
}

Options Seeded(std::uint64_t seed) {
  Options options;
  options.seed = seed;
  options.validation = Validation::kNone;
  return options;
}

}  // namespace mjforge::forge
