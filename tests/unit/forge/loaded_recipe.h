#pragma once

#include <string>
#include <utility>
#include <vector>

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
    "  - {name: body, if: kind != 'other', type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A box that about half of the variants give a size below zero.
inline constexpr const char* kUnluckySpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: -0.1 .. 0.1\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A box whose material is planned over the batch.
inline constexpr const char* kExactSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: 0.1 .. 0.2\n"
    "  density: {choice: [300, 500, 800], weights: [2, 1, 1], exact: true}\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1 .. 0.2, 0.1, height], density: density}\n";

/// A spec in a file of a fresh folder, other files (name, text) beside it, loaded
/// without findings.
struct LoadedRecipe {
  explicit LoadedRecipe(const std::string& text, spec::LoadOptions options = {},
                        const std::vector<std::pair<std::string, std::string>>& beside = {});

  harness::TemporaryFolder folder;
  diag::Sources sources;
  Recipe recipe;
};

/// Variants that MuJoCo does not look at.
Options Seeded(std::uint64_t seed);

}  // namespace mjforge::forge
