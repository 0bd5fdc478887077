// Compares the joints in `view:` with the joints of the object and, if one is missing, with the
// joints that other variants of the spec may have.

#include "mjforge/assemble/shown_pose.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/starts.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Returns true if the names are equal, or if the longer name ends with "_" and the shorter name.
bool EqualUpToPrefix(std::string_view a, std::string_view b) {
  if (a.size() < b.size()) std::swap(a, b);
  return a.ends_with(b) && (a.size() == b.size() || a[a.size() - b.size() - 1] == '_');
}

// Returns true if a name in the spec may evaluate to the name of the joint. An expression in the
// name may give any text.
bool MayBe(const spec::Value& name, std::string_view joint) {
  if (const auto literal = spec::LiteralText(name)) return EqualUpToPrefix(*literal, joint);
  const auto* text = std::get_if<spec::Text>(&name.form);
  return text != nullptr && joint.find(text->pieces.front().literal) != joint.npos &&
         joint.ends_with(text->pieces.back().literal);
}

// Returns true if the spec, or one of its bodies, lists a joint that may have this name, even if
// `if` or `for` leaves the joint out in some variants.
bool MayHave(const spec::ObjectSpec& spec, std::string_view joint) {
  const auto may_be = [&](const spec::Entry& entry) { return MayBe(entry.name, joint); };
  return std::ranges::any_of(spec.joints, may_be) ||
         std::ranges::any_of(spec.bodies, [&](const spec::BodyEntry& body) {
           const bool may_be_absent = body.head.condition || !body.head.loops.empty();
           return std::ranges::any_of(body.joints, may_be) ||
                  (body.head.nested && MayHave(*body.head.nested, joint)) ||
                  (may_be_absent && body.head.Find(spec::Key::kMjcf) != nullptr);
         });
}

// Returns the joint with this name or, if there is none, the joints whose names end with "_NAME".
std::vector<const model::Joint*> FindJoints(std::span<const model::Joint* const> joints,
                                            std::string_view name) {
  const auto same = std::ranges::find(joints, name, &model::Joint::name);
  if (same != joints.end()) return {*same};
  std::vector<const model::Joint*> fitting;
  std::ranges::copy_if(joints, std::back_inserter(fitting), [&](const model::Joint* joint) {
    return joint->name.ends_with(fmt::format("_{}", name));
  });
  return fitting;
}

// Returns the hinges and slides. The positions of other joints have several numbers.
std::vector<const model::Joint*> MovableJoints(const model::Object& object) {
  std::vector<const model::Joint*> joints;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (joint.type == "hinge" || joint.type == "slide") joints.push_back(&joint);
    }
  }
  return joints;
}

// Warns of a position that is not in the unit of its joint.
void CheckUnit(const spec::PictureView::Position& position, const model::Joint& joint,
               diag::Findings& findings) {
  const expr::Dimension own = PositionDimension(joint);
  if (position.dimension.is_plain() || position.dimension == own) return;
  findings.Warn(Code::kModelBadValue, position.mark,
                fmt::format("view: joint {} is in {}, but this is in {}", Quoted(position.joint),
                            own.Text(), position.dimension.Text()));
}

}  // namespace

void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings) {
  if (spec.view.pose.empty()) return;
  const std::vector<const model::Joint*> joints = MovableJoints(object);
  for (const spec::PictureView::Position& position : spec.view.pose) {
    const std::string shown = Quoted(position.joint);
    const std::vector<const model::Joint*> fitting = FindJoints(joints, position.joint);
    if (fitting.empty() && !MayHave(spec, position.joint)) {
      const auto names = diag::Mapped<std::string_view>(joints, [&](const model::Joint* joint) {
        return model::OwnName(joint->name, object.name);
      });
      findings.Warn(Code::kModelUnknownReference, position.mark,
                    fmt::format("view: the object has no joint {}", shown),
                    diag::DidYouMean(position.joint, names));
    } else if (fitting.size() > 1) {
      findings.Warn(Code::kModelUnknownReference, position.mark,
                    fmt::format("view: {} could be joint {} or {}", shown, Quoted(fitting[0]->name),
                                Quoted(fitting[1]->name)),
                    "give its full name");
    } else if (fitting.size() == 1) {
      CheckUnit(position, *fitting[0], findings);
    }
  }
}

}  // namespace mjforge::assemble
