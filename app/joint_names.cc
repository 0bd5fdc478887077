// Finds the joints of a spec's first variant or of an MJCF file, for completion in shells.
#include "joint_names.h"

#include <fmt/format.h>

#include <memory>

#include "mjforge/forge/forge.h"
#include "mjforge/picture/picture.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct LoadedSubject {
  std::unique_ptr<picture::Subject> subject;
  std::string prefix;  // prefix of the names of the object's joints
};

LoadedSubject LoadVariant(const std::string& what, const std::vector<std::string>& settings) {
  Console console{MessageOptions()};
  SpecOptions options;
  options.settings = settings;
  const std::optional<forge::Recipe> recipe = LoadRecipe(what, options, console);
  if (!recipe || console.findings.HasErrors()) return {};
  forge::Variant variant;
  forge::Generator(*recipe, console.sources, {.validation = forge::Validation::kNone})
      .Make(0, variant);
  if (!variant.ok()) return {};
  std::string why_not;
  return {picture::Loader().LoadText(variant.document.text, variant.document.assets, why_not),
          variant.record.name + "_"};
}

std::string MeaningOf(const picture::Joint& joint) {
  const bool turns = joint.type == picture::Joint::Type::kHinge;
  std::string type = turns ? "hinge" : "slide";
  if (!joint.limited) return type;
  return fmt::format("{}, {:.3g} to {:.3g} {}", type, joint.range[0], joint.range[1],
                     turns ? "rad" : "m");
}

}  // namespace

std::vector<JointName> NamesOfJoints(const std::string& what,
                                     const std::vector<std::string>& settings) {
  std::string why_not;
  const LoadedSubject loaded = what.ends_with(".xml")
                                   ? LoadedSubject{picture::Loader().LoadFile(what, why_not), {}}
                                   : LoadVariant(what, settings);
  std::vector<JointName> names;
  if (!loaded.subject) return names;
  for (const picture::Joint& joint : loaded.subject->joints()) {
    if (!joint.IsMovable() || joint.name.empty()) continue;
    const bool prefixed = joint.name.starts_with(loaded.prefix);
    const std::string rest = joint.name.substr(prefixed ? loaded.prefix.size() : 0);
    diag::Findings ignored;
    const bool enough = loaded.subject->FindJoint(rest, ignored).has_value();
    names.push_back({joint.name, enough ? rest : joint.name, MeaningOf(joint)});
  }
  return names;
}

}  // namespace mjforge::app
