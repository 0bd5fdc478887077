// Checks of the key `detent` of a joint against the other keys of the joint.

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Keys of a joint that must not occur together with `detent:`. `stiffness` and `springdamper`
// define another spring; `screw` determines the range.
constexpr std::string_view kExcludedByDetent[] = {"stiffness", "springdamper", "screw"};

}  // namespace

void CheckDetent(const YamlNode& joint, const Entry& entry, Context& context) {
  const Field* detent = entry.Find(Key::kDetent);
  if (detent == nullptr) return;
  if (joint.Find("detent") != nullptr)
    RejectBeside("detent", kExcludedByDetent, joint, "a detent is a spring between two ends",
                 context);
  const std::string_view motion = JointType(entry.Find(Key::kType));
  if (motion == "free" || motion == "ball") {
    context.findings.Add(Code::kSpecConflict, detent->mark,
                         fmt::format("'detent' has no meaning for a {} joint", motion),
                         "only a hinge or a slide has two ends");
  } else if (entry.Find(Key::kRange) == nullptr) {
    context.findings.Add(Code::kSpecMissingKey, detent->mark, "'detent' without 'range'",
                         "the joint snaps to the ends of its range");
  }
}

}  // namespace mjforge::spec
