#ifndef MJFORGE_TESTS_UNIT_FORGE_LOADED_RECIPE_H_
#define MJFORGE_TESTS_UNIT_FORGE_LOADED_RECIPE_H_

#include <string>

#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// A box whose half size along z is drawn.
inline constexpr const char* kBoxSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: 0.1 .. 0.2\n"
    "  kind: {choice: [light, heavy]}\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A box that about half of the variants give a size below zero.
inline constexpr const char* kUnluckySpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: -0.1 .. 0.1\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A spec in a file of a fresh folder, loaded without findings.
struct LoadedRecipe {
  explicit LoadedRecipe(const std::string& text, spec::LoadOptions options = {});

  harness::TemporaryFolder folder;
  diag::Sources sources;
  Recipe recipe;
};

}  // namespace mjforge::forge

#endif  // MJFORGE_TESTS_UNIT_FORGE_LOADED_RECIPE_H_
