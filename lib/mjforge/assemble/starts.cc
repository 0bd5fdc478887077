// Reader of `pose:`, the start state, which is applied to joints, free bodies and actuators.

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/pose_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

constexpr Key kOrientations[] = {Key::kQuat, Key::kEuler, Key::kAxisAngle, Key::kXyAxes,
                                 Key::kZAxis};

}  // namespace

void Assembly::ReadStarts(Scope& scope) {
  const sample::StreamId pose = sample::Child(scope.values.root(), "pose");
  for (const spec::Entry& entry : scope.values.spec().pose) {
    repetition_.Expand(entry, scope.values, pose, starts_.size(),
                       [&] { ReadStart(scope, entry, pose); });
  }
}

// Reads one entry of `pose:`. The random stream of the position is named after the joint, not after
// the key, so that both forms of `pose:`, mapping and list, draw the same positions.
void Assembly::ReadStart(Scope& scope, const spec::Entry& entry, sample::StreamId pose) {
  RequestedStart& start = starts_.emplace_back();
  start.position.shown = scope.values.Text(entry.name, pose).value_or("");
  start.position.joint = scope.prefix + start.position.shown;
  start.position.mark = entry.mark;
  const sample::StreamId path = sample::Child(pose, std::string_view(start.position.shown));
  FieldReader reader(scope.values, findings_, "start", start.position.shown, path);
  const std::optional<model::Pose> X = ReadPose(reader, entry);
  if (X && entry.Find(Key::kPos) != nullptr) start.p = X->p;
  if (X && std::ranges::any_of(kOrientations, [&](Key key) { return entry.Find(key) != nullptr; }))
    start.q = X->q;
  for (const spec::Field& field : entry.fields) {
    const Key key = field.info->id;
    if (key == Key::kValue) {
      scope.values.Vector(field.value, path, start.position.numbers);
      start.position.value = &field.value;
    }
    if (key == Key::kVelocity) reader.Numbers(field, start.velocity);
    if (key == Key::kCtrl) start.ctrl = reader.Number(field);
    if (key == Key::kAct) start.act = reader.Number(field);
    start.is_actuator |= key == Key::kCtrl || key == Key::kAct;
  }
}

void Assembly::ApplyStarts(const Scope& scope, std::size_t first, std::size_t first_body) {
  if (starts_.size() == first) return;
  if (!object_.start_mark) object_.start_mark = starts_[first].position.mark;
  std::map<std::string_view, std::pair<model::Body*, model::Joint*>> joints;
  const auto add_joints = [&](model::Body& of) {
    for (model::Joint& joint : of.joints) joints.try_emplace(joint.name, &of, &joint);
  };
  add_joints(body());
  for (std::size_t i = first_body; i < object_.bodies.size(); ++i) add_joints(object_.bodies[i]);
  std::map<std::pair<bool, std::string>, diag::SourceMark> known;
  for (std::size_t i = first; i < starts_.size(); ++i) {
    RequestedStart& start = starts_[i];
    const RequestedPosition& position = start.position;
    const auto [earlier, is_new] =
        known.try_emplace({start.is_actuator, position.joint}, position.mark);
    const auto found = joints.find(position.joint);
    if (!is_new) {
      findings_
          .Add(Code::kSpecConflict, position.mark,
               fmt::format("the start of {} {} is given twice",
                           start.is_actuator ? "actuator" : "joint", Quoted(position.shown)))
          .notes.push_back({earlier->second, "first here"});
    } else if (start.is_actuator) {
      ApplySetpoint(start);
    } else if (found != joints.end()) {
      ApplyStart(scope, start, *found->second.first, *found->second.second);
    } else {
      lost_starts_.push_back(std::move(start));
    }
  }
  starts_.resize(first);
}

void Assembly::ApplyStart(const Scope& scope, const RequestedStart& start, model::Body& of,
                          model::Joint& joint) {
  const RequestedPosition& position = start.position;
  const auto report = [&](const std::string& wrong, std::string hint) {
    findings_.Add(Code::kModelBadValue, position.mark,
                  fmt::format("{} of joint {} {}", start.key, Quoted(position.shown), wrong),
                  std::move(hint));
  };
  // A body with `place:` has no parent until its place has been found.
  const bool is_root = &of == &object_.bodies[static_cast<std::size_t>(scope.body)];
  const bool has_place = !of.place_name.empty() || (of.parent < 0 && !is_root);
  if (!start.velocity.empty() && start.velocity.size() != VelocityCount(joint)) {
    report(fmt::format("has {} instead of {} numbers of velocity", start.velocity.size(),
                       VelocityCount(joint)),
           joint.type == "free" ? "the velocity x y z, then the angular velocity x y z" : "");
  } else if (!start.velocity.empty()) {
    joint.start_velocity = start.velocity;
  }
  if ((start.p || start.q) && joint.type != "free") {
    report(fmt::format("has a pose, but it is a {}", joint.type), "write its `value`");
  } else if ((start.p || start.q) && has_place) {
    report("has a pose, but `place:` gives its body another", "remove one of them");
  } else if (start.p || start.q) {
    const model::Pose X_BS = of.parent == scope.body ? scope.X_BS : model::Pose();
    if (start.p) of.X_PB.p = X_BS * *start.p;
    if (start.q) of.X_PB.q = (X_BS.q * *start.q).normalized();
  }
  if (position.numbers.empty()) return;
  if (auto qpos = ToQpos(start.key, position, joint)) joint.start = *std::move(qpos);
}

void Assembly::ApplySetpoint(RequestedStart& start) {
  const std::string& name = start.position.joint;
  const std::span<const model::Element> actuators = model::ElementsOf(object_, "actuator");
  if (std::ranges::find(actuators, name, &model::Element::name) == actuators.end()) {
    lost_starts_.push_back(std::move(start));
    return;
  }
  auto found = std::ranges::find(object_.setpoints, name, &model::Setpoint::actuator);
  if (found == object_.setpoints.end()) {
    found = object_.setpoints.insert(found, model::Setpoint());
    found->actuator = name;
  }
  if (start.ctrl) found->ctrl = start.ctrl;
  if (start.act) found->act = start.act;
  found->mark = start.position.mark;
}

void Assembly::ReportLostStarts() {
  for (const RequestedStart& start : lost_starts_) {
    const RequestedPosition& position = start.position;
    std::string_view why;
    if (references_.IsRemoved(position.joint)) {
      why = "attaching its spec removed the joint";
    } else if (model::FindJoint(object_, position.joint) != nullptr) {
      why = "a free body starts where the outer spec has it";
    }
    if (start.is_actuator) {
      findings_.Add(
          Code::kModelUnknownReference, position.mark,
          fmt::format("{}: the object has no actuator {}", start.key, Quoted(position.shown)));
    } else if (why.empty()) {
      ReportUnknownJoint(start.key, position);
    } else {
      findings_.Warn(
          Code::kAttachNotCarried, position.mark,
          fmt::format("{} of joint {} is left out: {}", start.key, Quoted(position.shown), why));
    }
  }
}

}  // namespace mjforge::assemble
