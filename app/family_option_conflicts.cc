// Finds options of `mjforge generate` that do not fit the destination. A family (variants of one
// MJCF with arrays of the numbers in which they differ) needs -o NAME.npz.

#include "family_option_conflicts.h"

#include <fmt/format.h>

namespace mjforge::app {

std::string FindFamilyConflict(const std::string& output, const batch::Request& request) {
  if (request.destination.kind != output::Destination::Kind::kFamily) {
    if (request.variant.mocap) return "--mocap is for families, such as -o NAME.npz";
    if (request.variant.pad > 0) return "--pad is for families, such as -o NAME.npz";
    return {};
  }
  const mjcf::TargetRules& rules = mjcf::RulesOf(request.variant.target);
  if (request.count < 2)
    return fmt::format("-o {}: a family has at least two variants; add -n", output);
  if (request.variant.validation == forge::Validation::kNone)
    return fmt::format("--validate none: the numbers of '{}' are those that MuJoCo computes",
                       output);
  if (request.variant.each) return "--each: a family has one model; write to a folder";
  const bool is_split = request.variant.layout == manifest::Layout::kSplit;
  if (is_split != request.destination.IsSplit()) {
    return is_split ? "--layout split: a family per structure needs a name such as NAME_%s.npz"
                    : fmt::format("-o {}: a family per structure needs --layout split", output);
  }
  if (request.variant.assets == mjcf::AssetForm::kFiles)
    return "--assets files: meshes and textures of a family are inline, in its base MJCF";
  if (request.variant.name.find('$') != std::string::npos)
    return fmt::format("--name {}: the variants of a family have one name", request.variant.name);
  if (rules.has_prefix && rules.has_free_joint) return {};
  return fmt::format("--target {}: its host loads files, one by one; write to a folder",
                     rules.name);
}

}  // namespace mjforge::app
