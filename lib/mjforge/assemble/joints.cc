// Joints of bodies: types, axes, ranges, and the root joints of a spec.

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/detents.h"
#include "mjforge/assemble/pose_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

bool ReadType(FieldReader& reader, const spec::Entry& entry, model::Joint& joint) {
  std::string word = "hinge";
  const bool good = reader.ReadOptional(entry, Key::kType, &FieldReader::Word, word);
  constexpr std::array<std::string_view, 4> kTypes = {"free", "ball", "slide", "hinge"};
  joint.type = *std::ranges::find(kTypes, word);
  return good;
}

// Returns the rule of MuJoCo that `range` violates for this joint type; empty if the range is
// valid.
std::string_view BrokenRange(std::string_view type, const Eigen::Vector2d& range) {
  const double lower = range[0];
  const double upper = range[1];
  if (type == "free") return "has no meaning for a free joint";
  if (type == "ball") {
    if (lower != 0) return "must begin with 0 for a ball joint";
    return upper > 0 ? "" : "must end above 0";
  }
  return lower < upper ? "" : "must go from a smaller to a larger number";
}

// Reads the range of a joint. The range is in force unless the entry has `limited: false`.
bool ReadRange(FieldReader& reader, const spec::Entry& entry, model::Joint& joint) {
  std::optional<Eigen::Vector2d> range;
  std::optional<bool> limited;
  if (!reader.ReadOptional(entry, Key::kRange, &FieldReader::Vector<2>, range) ||
      !reader.ReadOptional(entry, Key::kLimited, &FieldReader::Boolean, limited))
    return false;
  if (limited == false) return true;
  if (limited && !range)
    return reader.Report(Code::kModelBadValue, *entry.Find(Key::kLimited),
                         "is true, but it has no range");
  if (!range) return true;
  const std::string_view broken = BrokenRange(joint.type, *range);
  if (!broken.empty())
    return reader.Report(Code::kModelBadValue, *entry.Find(Key::kRange),
                         fmt::format("is {} .. {}; it {}", expr::NumberText((*range)(0)),
                                     expr::NumberText((*range)(1)), broken));
  joint.range = range;
  return true;
}

}  // namespace

bool ReadJointGeometry(FieldReader& reader, const spec::Entry& entry, model::Joint& joint) {
  bool good = ReadType(reader, entry, joint);
  good &= reader.ReadOptional(entry, Key::kPos, &FieldReader::Vector<3>, joint.pos);
  good &= reader.ReadOptional(entry, Key::kAxis, ReadDirection, joint.axis);
  return good;
}

void Assembly::AddRootJoints(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (spec.root_joints == spec::RootJoints::kFree) {
    model::Joint& joint = body().joints.emplace_back();
    joint.name = scope.prefix + "joint0";
  }
  if (spec.root_joints != spec::RootJoints::kList) return;
  AddJoints(scope, spec.joints, sample::Child(scope.values.root(), "joints"));
}

void Assembly::AddJoints(Scope& scope, const std::vector<spec::Entry>& entries,
                         sample::StreamId joints) {
  for (const spec::Entry& entry : entries) {
    repetition_.Expand(entry, scope.values, joints, body().joints.size(),
                       [&] { AddJoint(scope, entry, joints); });
  }
}

void Assembly::MarkRootJointsRemoved(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  const std::string origin = fmt::format("spec '{}'", spec.name);
  if (spec.root_joints == spec::RootJoints::kFree) {
    references_.MarkRemoved(scope.prefix + "joint0", origin);
  }
  for (const spec::Entry& entry : spec.joints) {
    repetition_.ForEach(entry, scope.values, scope.values.root(), [&] {
      const auto name = ReadName(scope, entry, scope.values.root(), findings_);
      if (!name) return;
      const std::string joint = scope.prefix + *name;
      if (entry.FindChild(spec::kScrewElement) == nullptr)
        return references_.MarkRemoved(joint, origin);
      for (const std::string_view end : {kRiseEnding, kTurnEnding})
        references_.MarkRemoved(joint + std::string(end), origin);
    });
  }
}

void Assembly::AddJoint(Scope& scope, const spec::Entry& entry, sample::StreamId joints) {
  const std::optional<std::string> name = ReadName(scope, entry, joints, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, "joint", *name,
                     sample::Child(joints, std::string_view(*name)));
  model::Joint joint;
  bool good = ReadJointGeometry(reader, entry, joint);
  joint.name = scope.prefix + *name;
  joint.mark = entry.mark;
  good &= ReadRange(reader, entry, joint);
  good &= ReadAttributes(reader, entry, joint.attributes);
  if (!good || !ReadDetent(reader, entry, joint)) return;
  if (const spec::Entry* screw = entry.FindChild(spec::kScrewElement)) {
    couplings_.AddScrew(scope, reader, *screw, std::move(joint), body());
    return;
  }
  if (const spec::Entry* couple = entry.FindChild(spec::kCoupleElement))
    couplings_.AddCouple(scope, reader, *couple, joint);
  if (const spec::Field* field = entry.Find(Key::kStart)) {
    RequestedStart& start = starts_.emplace_back();
    start.key = "start";
    start.position = {
        .joint = joint.name, .shown = *name, .numbers = {}, .value = nullptr, .mark = field->mark};
    scope.values.Vector(field->value,
                        sample::Child(sample::Child(joints, std::string_view(*name)), "start"),
                        start.position.numbers);
  }
  body().joints.push_back(std::move(joint));
}

}  // namespace mjforge::assemble
