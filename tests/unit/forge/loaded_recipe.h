// Recipes for tests of the generator.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// Spec of a box whose half size along z is drawn.
inline constexpr const char* kBoxSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: 0.1 .. 0.2\n"
    "  kind: {choice: [light, heavy]}\n"
    "parts:\n"
    "  - {name: body, if: kind != 'other', type: box, size: [0.1, 0.1, height], density: 500}\n";

/// Spec of a box whose size is negative in about half of the variants.
inline constexpr const char* kUnluckySpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: -0.1 .. 0.1\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// Spec of a box whose material is an exact choice over the batch.
inline constexpr const char* kExactSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: 0.1 .. 0.2\n"
    "  density: {choice: [300, 500, 800], weights: [2, 1, 1], exact: true}\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1 .. 0.2, 0.1, height], density: density}\n";

/// A recipe loaded without findings from a file in a temporary folder, with other files (name,
/// text) beside it.
struct LoadedRecipe {
  explicit LoadedRecipe(const std::string& text, spec::LoadOptions options = {},
                        const std::vector<std::pair<std::string, std::string>>& beside = {});

  harness::TemporaryFolder folder;
  diag::Sources sources;
  Recipe recipe;
};

/// Returns options for variants that are not loaded in MuJoCo.
Options Seeded(std::uint64_t seed);

}  // namespace mjforge::forge
