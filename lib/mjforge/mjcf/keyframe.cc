// Start state of an object as MuJoCo's qpos, qvel, act and ctrl, and the <keyframe> that contains
// this state.

#include <algorithm>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// Appends the qpos of a free joint.
void AddPose(const model::Pose& pose, double lift, std::vector<double>& out) {
  out.push_back(pose.p[0]);
  out.push_back(pose.p[1]);
  out.push_back(pose.p[2] + lift);
  const Eigen::Vector4d quat = model::Wxyz(pose.q);
  out.insert(out.end(), quat.begin(), quat.end());
}

void AddPositions(const model::Body& body, double lift, std::vector<double>& qpos) {
  for (const model::Joint& joint : body.joints) {
    if (joint.type == "free") {
      AddPose(body.X_PB, lift, qpos);
      continue;
    }
    const auto position = HasStart(joint) ? joint.start : model::ZeroPosition(joint);
    qpos.insert(qpos.end(), position.begin(), position.end());
  }
}

void AddVelocities(const model::Body& body, std::vector<double>& qvel) {
  for (const model::Joint& joint : body.joints) {
    const std::size_t end = qvel.size() + model::VelocityCount(joint);
    qvel.insert(qvel.end(), joint.start_velocity.begin(), joint.start_velocity.end());
    qvel.resize(end);
  }
}

// Adds the controls and activations of the object's actuators. Ignores setpoints of actuators that
// were dropped for the target.
void AddSetpoints(const model::Object& object, StartState& start) {
  if (object.setpoints.empty()) return;
  bool acts = false;
  for (const model::Element& actuator : model::ElementsOf(object, "actuator")) {
    const auto* setpoint = diag::Find(object.setpoints, actuator.name, &model::Setpoint::actuator);
    start.ctrl.push_back(setpoint->ctrl.value_or(0));
    if (setpoint->act) start.act.push_back(*setpoint->act);
    acts |= setpoint->act.value_or(0) != 0;
  }
  if (!acts) start.act.clear();
  if (std::ranges::count(start.ctrl, 0.0) == std::ssize(start.ctrl)) start.ctrl.clear();
}

}  // namespace

StartState StartStateOf(const model::Object& object, double lift) {
  StartState start;
  AddSetpoints(object, start);
  const bool moves = model::AnyJoint(object, model::HasStartVelocity);
  if (!moves && !model::AnyJoint(object, model::HasStart) && start.act.empty() &&
      start.ctrl.empty())
    return start;
  for (const int i : DepthFirstOrder(object)) {
    const model::Body& body = object.bodies[static_cast<std::size_t>(i)];
    AddPositions(body, lift, start.qpos);
    if (moves) AddVelocities(body, start.qvel);
  }
  return start;
}

void WriteKeyframe(const model::Object& object, double lift, ElementWriter& writer) {
  const StartState start = StartStateOf(object, lift);
  if (start.qpos.empty() && start.act.empty() && start.ctrl.empty()) return;
  writer.OpenElement("keyframe");
  writer.BeginContent();
  writer.OpenElement("key", object.start_mark);
  writer.WriteText("name", object.name, kStartSuffix);
  const auto write = [&](std::string_view name, const std::vector<double>& numbers) {
    if (!numbers.empty()) writer.WriteNumbers(name, numbers, ElementWriter::NumberFormat::kFlushed);
  };
  write("qpos", start.qpos);
  write("qvel", start.qvel);
  write("act", start.act);
  write("ctrl", start.ctrl);
  writer.CloseEmpty();
  writer.EndElement("keyframe");
}

}  // namespace mjforge::mjcf
