#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/engine/memory_files.h"
#include "recipes.h"

namespace mjforge::bench {

/// As small as MuJoCo takes it.
inline constexpr std::string_view kTightSize =
    "  <size njmax=\"1\" nconmax=\"1\" nstack=\"4096\"/>\n";

/// The texts of a recipe's first variants, `size` put in where validation puts
/// its own.
std::vector<std::string> Texts(const forge::Recipe& recipe, std::string_view size, int count);

/// mj_loadXML from memory and nothing else.
class BareLoader {
 public:
  /// Loads and deletes a model; ends the program if MuJoCo refuses it.
  void Load(const std::string& text);

 private:
  engine::MemoryFiles files_;
};

}  // namespace mjforge::bench
