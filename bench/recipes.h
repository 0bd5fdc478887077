#pragma once

#include <string>
#include <vector>

#include "mjforge/forge/forge.h"

namespace mjforge::bench {

/// A spec ready to make variants. Ends the program if it does not load.
struct LoadedRecipe {
  diag::Sources sources;
  forge::Recipe recipe;
};

/// The bundled hammer.
LoadedRecipe& Hammer();

/// A spec that `reference` names, with parameters set from outside.
LoadedRecipe Named(const std::string& reference, const std::vector<spec::Setting>& settings);

/// An object of `parts` boxes in a row, sizes drawn, from one `for` entry.
LoadedRecipe Row(int parts);

/// The spec of a text.
LoadedRecipe FromText(const std::string& yaml);

/// One variant of a recipe through sample, model and mjcf, into `document`.
void MakeText(const forge::Recipe& recipe, model::Assembler& assembler, std::uint64_t index,
              mjcf::MjcfDocument& document);

}  // namespace mjforge::bench
