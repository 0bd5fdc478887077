// Specs for benchmarks.

#pragma once

#include <string>
#include <vector>

#include "mjforge/assemble/assemble.h"
#include "mjforge/forge/forge.h"

namespace mjforge::bench {

/// A loaded spec, ready to make variants. The functions below end the program if a spec does not
/// load.
struct LoadedRecipe {
  diag::Sources sources;
  forge::Recipe recipe;
};

/// Returns robosuite's hammer.
LoadedRecipe& Hammer();

/// Loads the spec with this name or path, with these settings.
LoadedRecipe Named(const std::string& reference, const std::vector<spec::Setting>& settings);

/// Returns a row of boxes with drawn sizes, made by one `for` entry.
LoadedRecipe Row(int parts);

/// Loads a spec from its text.
LoadedRecipe FromText(const std::string& yaml);

/// Makes a variant's text by sample, model and mjcf, without validation.
void MakeText(const forge::Recipe& recipe, assemble::Assembler& assembler, std::uint64_t index,
              mjcf::MjcfDocument& document);

}  // namespace mjforge::bench
