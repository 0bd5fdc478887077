// Check for names of elements that clash with names that the target's host adds itself, or that
// have a special meaning for the host because of their prefix or suffix.

#include <set>

#include <fmt/format.h>

#include "mjforge/mjcf/adapt.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {
namespace {

using diag::Code;

class HostNameChecker {
 public:
  HostNameChecker(const model::Object& object, const TargetRules& rules, diag::Findings& findings)
      : rules_(rules), prefix_(object.name + "_"), findings_(findings) {}

  /// Checks the name of an element. `word` is the element's name in messages ("part"); `kind` is
  /// its MJCF tag ("geom").
  void Check(std::string_view word, std::string_view kind, std::string_view name,
             diag::SourceMark mark) {
    if (!rules_.has_prefix && name.starts_with(prefix_)) {
      findings_.Add(Code::kModelBadName, mark,
                    fmt::format("{} '{}' begins with the object's name: {} adds the prefix '{}' "
                                "only to names that lack it",
                                word, name, rules_.name, prefix_),
                    "rename it, or the object (--name)");
    }
    for (const HostName& host : rules_.host_names) {
      if (host.kind != kind || host.name != name) continue;
      findings_.Add(Code::kModelDuplicateName, mark,
                    fmt::format("{} '{}' has the name of a {} that {} adds itself", word, name,
                                kind, rules_.name),
                    "rename it");
    }
    if (kind == "geom" && !rules_.region_prefix.empty() && name.starts_with(rules_.region_prefix)) {
      findings_.Add(Code::kModelBadName, mark,
                    fmt::format("{} '{}' would become a region: {} treats every geom as one if its "
                                "name begins with '{}'",
                                word, name, rules_.name, rules_.region_prefix),
                    "rename it");
    }
  }

  /// Reports parts whose name equals the name of the visual copy that the host makes of a collision
  /// geom.
  void CheckVisualCopies(const model::Object& object) {
    if (rules_.visual_copy_suffix.empty()) return;
    std::set<std::string, std::less<>> colliding;
    for (const model::Body& body : object.bodies) {
      for (const model::Part& part : body.parts) {
        if (part.role != model::Role::kVisual) colliding.insert(part.name);
      }
    }
    for (const model::Body& body : object.bodies) {
      for (const model::Part& part : body.parts) {
        const std::string_view name = part.name;
        const bool has_geom_of_its_name = part.as_is || part.role != model::Role::kVisual;
        if (!has_geom_of_its_name || !name.ends_with(rules_.visual_copy_suffix)) continue;
        const auto base = name.substr(0, name.size() - rules_.visual_copy_suffix.size());
        if (!colliding.contains(base)) continue;
        findings_.Add(Code::kModelDuplicateName, part.mark,
                      fmt::format("part '{}' has the name of the visual copy of '{}' that {} makes",
                                  name, base, rules_.name),
                      "rename it");
      }
    }
  }

 private:
  const TargetRules& rules_;
  std::string prefix_;
  diag::Findings& findings_;
};

}  // namespace

void CheckNames(const model::Object& object, const TargetRules& rules, diag::Findings& findings) {
  HostNameChecker checker(object, rules, findings);
  for (const model::Body& body : object.bodies) {
    checker.Check("body", "body", body.name, body.mark);
    for (const model::Joint& joint : body.joints) {
      const bool is_dropped = &body == &object.bodies.front() && joint.type == "free";
      if (!is_dropped) checker.Check("joint", "joint", joint.name, joint.mark);
    }
    for (const model::Site& site : body.sites) checker.Check("site", "site", site.name, site.mark);
    // Name of the previous part. SplitRoles() makes two neighbouring parts with the same name,
    // which must get only one finding.
    std::string_view last;
    for (const model::Part& part : body.parts) {
      if (part.name != last) checker.Check("part", "geom", part.name, part.mark);
      last = part.name;
    }
  }
  checker.CheckVisualCopies(object);
}

}  // namespace mjforge::mjcf
