#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

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
  BareLoader();

  /// Loads and deletes a model; ends the program if MuJoCo refuses it.
  void Load(const std::string& text);

 private:
  std::unique_ptr<mjVFS> vfs_;
};

}  // namespace mjforge::bench
