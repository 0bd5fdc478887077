// Reader of `screw:` and `couple:`, which couple two joints.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Keys of a joint that must not occur together with `screw:`, because the screw determines them.
constexpr std::string_view kOfScrew[] = {"type", "axis",  "range", "limited",
                                         "ref",  "start", "couple"};

// Reports a joint whose motion cannot be coupled to another joint by an MJCF equality, and `lead`
// for a hinge.
void CheckMotion(const Entry& joint, const Entry& couple, Context& context) {
  const std::string_view motion = JointType(joint.Find(Key::kType));
  if (motion == "free" || motion == "ball") {
    context.findings.Add(Code::kSpecConflict, couple.mark,
                         fmt::format("'couple' has no meaning for a {} joint", motion),
                         "only a hinge or a slide follows another joint");
  }
  const Field* lead = couple.Find(Key::kLead);
  if (lead != nullptr && motion == "hinge") {
    context.findings.Add(Code::kSpecConflict, lead->mark, "'lead' has no meaning for a hinge",
                         "`lead` is how far a slide moves for each turn of a hinge; `ratio` is for "
                         "any two joints");
  }
}

}  // namespace

void ReadCouplings(const YamlNode& joint, Entry& entry, Context& context) {
  if (ReadChild(kScrewElement, joint, entry, context) != nullptr) {
    RejectBeside("screw", kOfScrew, joint, "a thread decides it", context);
    std::erase_if(entry.fields, [](const Field& field) {
      return std::ranges::find(kOfScrew, field.info->key) != std::end(kOfScrew);
    });
  }
  const Entry* couple = ReadChild(kCoupleElement, joint, entry, context);
  if (couple == nullptr) return;
  CheckMotion(entry, *couple, context);
  if (!couple->Find(Key::kRatio) && !couple->Find(Key::kLead) && !couple->Find(Key::kPolycoef)) {
    context.findings.Add(Code::kSpecMissingKey, couple->mark,
                         "'couple' without 'ratio', 'lead' or 'polycoef'",
                         "`ratio` is how far this joint moves for each m or rad of the other one");
  }
}

}  // namespace mjforge::spec
