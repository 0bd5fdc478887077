// Start positions of the joints (qpos), and the keyframe with them.

#include <algorithm>

#include "mjforge/mjcf/sections.h"

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

// Appends the position in which a joint has its default value: `ref`, or the identity of a ball
// joint.
void AddZero(const model::Joint& joint, std::vector<double>& out) {
  if (joint.type == "ball") {
    for (const double number : {1.0, 0.0, 0.0, 0.0}) out.emplace_back(number);
    return;
  }
  const auto* ref = model::FindAttribute(joint.attributes, "ref");
  out.push_back(ref == nullptr ? 0.0 : ref->numbers.front());
}

}  // namespace

std::vector<double> StartPositions(const model::Object& object, double lift) {
  std::vector<double> positions;
  const auto has_start = [](const model::Joint& joint) { return !joint.start.empty(); };
  const auto is_posed = [&](const model::Body& body) {
    return std::ranges::any_of(body.joints, has_start);
  };
  if (std::ranges::none_of(object.bodies, is_posed)) return positions;
  for (const int i : DepthFirstOrder(object)) {
    const model::Body& body = object.bodies[static_cast<std::size_t>(i)];
    for (const model::Joint& joint : body.joints) {
      if (joint.type == "free") {
        AddPose(body.X_PB, lift, positions);
      } else if (has_start(joint)) {
        positions.insert(positions.end(), joint.start.begin(), joint.start.end());
      } else {
        AddZero(joint, positions);
      }
    }
  }
  return positions;
}

void WriteKeyframe(const model::Object& object, double lift, ElementWriter& writer) {
  const std::vector<double> positions = StartPositions(object, lift);
  if (positions.empty()) return;
  writer.OpenElement("keyframe");
  writer.BeginContent();
  writer.OpenElement("key");
  writer.WriteText("name", object.name, kStartSuffix);
  writer.WriteNumbers("qpos", positions, ElementWriter::NumberFormat::kFlushed);
  writer.CloseEmpty();
  writer.EndElement("keyframe");
}

}  // namespace mjforge::mjcf
