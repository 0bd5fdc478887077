#include <algorithm>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

void AddPose(const model::Pose& pose, const Traced<double>& lift,
             std::vector<Traced<double>>& out) {
  out.push_back(tape::Element(pose.p, 0));
  out.push_back(tape::Element(pose.p, 1));
  out.push_back(tape::Element(pose.p, 2) + lift);
  const auto wxyz = [](const Eigen::Quaterniond& q) {
    return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
  };
  const Traced<Eigen::Vector4d> turn = tape::Apply(wxyz, pose.q);
  for (std::size_t i = 0; i < 4; ++i) out.push_back(tape::Element(turn, i));
}

void AddZero(const model::Joint& joint, std::vector<Traced<double>>& out) {
  if (joint.type == "ball") {
    for (const double number : {1.0, 0.0, 0.0, 0.0}) out.emplace_back(number);
    return;
  }
  const auto ref = std::ranges::find(joint.attributes, "ref", &model::Attribute::name);
  out.push_back(ref == joint.attributes.end() ? Traced<double>(0.0) : ref->numbers.front());
}

}  // namespace

std::vector<Traced<double>> StartPositions(const model::Object& object,
                                           const Traced<double>& lift) {
  std::vector<Traced<double>> positions;
  const auto has_start = [](const model::Joint& joint) { return !joint.start.empty(); };
  const auto is_posed = [&](const model::Body& body) {
    return std::ranges::any_of(body.joints, has_start);
  };
  if (std::ranges::none_of(object.bodies, is_posed)) return positions;
  for (const int i : DepthFirst(object)) {
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

void WriteKeyframe(const model::Object& object, const Traced<double>& lift, ElementWriter& writer) {
  const std::vector<Traced<double>> positions = StartPositions(object, lift);
  if (positions.empty()) return;
  writer.Open("keyframe");
  writer.Content();
  writer.Open("key");
  writer.Text("name", object.name, kStartSuffix);
  writer.Numbers("qpos", positions, ElementWriter::Spelling::kWithoutNoise);
  writer.Close();
  writer.End("keyframe");
}

}  // namespace mjforge::mjcf
