// Loading texts in MuJoCo without any of mjforge's checks.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/engine/memory_files.h"
#include "recipes.h"

namespace mjforge::bench {

/// The smallest sizes that MuJoCo accepts.
inline constexpr std::string_view kTightSize =
    "  <size njmax=\"1\" nconmax=\"1\" nstack=\"4096\"/>\n";

/// Returns the texts of a recipe's first variants, with `size` at the place where validation
/// inserts its own.
std::vector<std::string> Texts(const forge::Recipe& recipe, std::string_view size, int count);

/// Loads texts from memory with mj_loadXML.
class BareLoader {
 public:
  /// Loads and deletes a model. Ends the program if MuJoCo rejects the text.
  void Load(const std::string& text);

 private:
  engine::MemoryFiles files_;
};

}  // namespace mjforge::bench
