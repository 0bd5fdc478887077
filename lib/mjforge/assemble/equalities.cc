// Check of equalities at the start: how far joints, connects and welds are from being satisfied.

#include <algorithm>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/start_state.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

constexpr double kLengthTolerance = 1e-4;                    // m
constexpr double kAngleTolerance = std::numbers::pi / 1800;  // rad

const model::Attribute* Given(const model::Element& element, std::string_view name) {
  return model::FindAttribute(element.attributes, name);
}

// Returns a vector attribute; `otherwise` if the element does not have it.
Eigen::Vector3d PointOf(const model::Element& element, std::string_view name) {
  const model::Attribute* attribute = Given(element, name);
  if (attribute == nullptr) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(attribute->numbers.data());
}

class EqualityChecker {
 public:
  EqualityChecker(const model::Object& object, diag::Findings& findings)
      : object_(object),
        findings_(findings),
        started_(model::SubtreePoses(object.bodies, 0)),
        zero_(model::ZeroPoses(object.bodies)) {
    for (const model::Body& body : object.bodies) {
      for (const model::Joint& joint : body.joints) joints_.emplace(joint.name, &joint);
    }
  }

  void Check(const model::Element& equality) {
    const model::Attribute* active = Given(equality, "active");
    if (active != nullptr && active->text == "false") return;
    if (equality.tag == "joint") CheckJoint(equality);
    if (equality.tag == "connect" || equality.tag == "weld") CheckBodies(equality);
  }

 private:
  const model::Joint* JointOf(const model::Element& equality, std::string_view key) const {
    const model::Attribute* name = Given(equality, key);
    const auto found = name == nullptr ? joints_.end() : joints_.find(name->text);
    return found == joints_.end() ? nullptr : found->second;
  }

  // Returns how far a hinge or slide is from its zero at the start; 0 for no joint.
  static double DisplacementOf(const model::Joint* joint) {
    if (joint == nullptr || joint->start.size() != 1) return 0;
    return joint->start[0] - model::ZeroPosition(*joint)[0];
  }

  void CheckJoint(const model::Element& equality) {
    const model::Joint* first = JointOf(equality, "joint1");
    const model::Joint* second = JointOf(equality, "joint2");
    const bool is_started = (first != nullptr && !first->start.empty()) ||
                            (second != nullptr && !second->start.empty());
    if (first == nullptr || first->type == "ball" || !is_started) return;
    constexpr double kDefaults[] = {0, 1, 0, 0, 0};
    const model::Attribute* given = Given(equality, "polycoef");
    const double x = DisplacementOf(second);
    double wanted = 0;
    for (std::size_t i = second == nullptr ? 1 : 5; i-- > 0;) {
      const bool is_given = given != nullptr && i < given->numbers.size();
      wanted = wanted * x + (is_given ? given->numbers[i] : kDefaults[i]);
    }
    const bool is_slide = first->type == "slide";
    Report(equality, std::abs(DisplacementOf(first) - wanted), is_slide,
           fmt::format("joint {} belongs at {}", Quoted(first->name),
                       expr::NumberText(model::ZeroPosition(*first)[0] + wanted)));
  }

  // Returns X_WB of the body that an attribute names; the identity for the world.
  static model::Pose PoseOf(const model::Element& equality, std::string_view key,
                            const std::vector<model::Pose>& poses,
                            const std::vector<model::Body>& bodies) {
    const model::Attribute* name = Given(equality, key);
    if (name == nullptr) return {};
    const auto body = std::ranges::find(bodies, name->text, &model::Body::name);
    return body == bodies.end() ? model::Pose()
                                : poses[static_cast<std::size_t>(body - bodies.begin())];
  }

  // Returns the pose of the second body in the first one.
  model::Pose RelativePose(const model::Element& equality,
                           const std::vector<model::Pose>& poses) const {
    return PoseOf(equality, "body1", poses, object_.bodies).Inverse() *
           PoseOf(equality, "body2", poses, object_.bodies);
  }

  // A connect holds its anchor, a point of the first body, together. A weld has an anchor in the
  // second body, and also keeps the orientation.
  void CheckBodies(const model::Element& equality) {
    const model::Pose X_12 = RelativePose(equality, started_);
    const model::Pose zero = RelativePose(equality, zero_);
    model::Pose wanted = zero;
    Eigen::Vector3d anchor = PointOf(equality, "anchor");
    const model::Attribute* relpose = Given(equality, "relpose");
    if (equality.tag == "connect") {
      anchor = zero.Inverse() * anchor;
    } else if (relpose != nullptr && relpose->numbers.size() == 7) {
      const auto& n = relpose->numbers;
      const Eigen::Quaterniond q(n[3], n[4], n[5], n[6]);
      if (q.norm() > 0) wanted = {Eigen::Vector3d(n.data()), q.normalized()};
    }
    if (Distance(X_12, zero, anchor) + X_12.q.angularDistance(zero.q) < 1e-9) return;  // not moved
    const model::Attribute* torque = Given(equality, "torquescale");
    const bool keeps_turn = equality.tag == "weld" && (torque == nullptr || torque->numbers[0] > 0);
    const std::string hint = "give the joints of both bodies their starts";
    Report(equality, Distance(X_12, wanted, anchor), true, hint);
    if (keeps_turn) Report(equality, X_12.q.angularDistance(wanted.q), false, hint);
  }

  static double Distance(const model::Pose& a, const model::Pose& b, const Eigen::Vector3d& point) {
    return (a * point - b * point).norm();
  }

  void Report(const model::Element& equality, double amount, bool is_length, std::string hint) {
    if (amount <= (is_length ? kLengthTolerance : kAngleTolerance)) return;
    const std::string text = is_length ? expr::RoundedText(1000 * amount, 3) + " mm"
                                       : expr::RoundedText(amount, 3) + " rad";
    findings_.Add(Code::kModelBadStart, equality.mark,
                  fmt::format("the start violates equality {} by {}", Quoted(equality.name), text),
                  std::move(hint));
  }

  const model::Object& object_;
  diag::Findings& findings_;
  std::vector<model::Pose> started_;  // X_WB at the start
  std::vector<model::Pose> zero_;     // X_WB with all joints at zero
  std::map<std::string_view, const model::Joint*> joints_;
};

}  // namespace

void CheckEqualities(const model::Object& object, diag::Findings& findings) {
  const std::span<const model::Element> equalities = model::ElementsOf(object, "equality");
  const auto is_started = [](const model::Body& body) {
    return std::ranges::any_of(body.joints,
                               [](const model::Joint& joint) { return !joint.start.empty(); });
  };
  if (equalities.empty() || std::ranges::none_of(object.bodies, is_started)) return;
  EqualityChecker checker(object, findings);
  for (const model::Element& equality : equalities) checker.Check(equality);
}

}  // namespace mjforge::assemble
