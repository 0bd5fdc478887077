// Check of equalities at the start: how far joints, connects and welds are from being satisfied.

#include <algorithm>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/model/forward_kinematics.h"
#include "mjforge/model/model.h"
#include "mjforge/model/names.h"
#include "mjforge/model/start_state.h"

namespace mjforge::model {
namespace {

using diag::Code;

constexpr double kLengthTolerance = 1e-4;                    // m
constexpr double kAngleTolerance = std::numbers::pi / 1800;  // rad

const Attribute* Given(const Element& element, std::string_view name) {
  return FindAttribute(element.attributes, name);
}

// Returns a vector attribute; `otherwise` if the element does not have it.
Eigen::Vector3d PointOf(const Element& element, std::string_view name) {
  const Attribute* attribute = Given(element, name);
  if (attribute == nullptr) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(attribute->numbers.data());
}

class EqualityChecker {
 public:
  EqualityChecker(const Object& object, diag::Findings& findings)
      : object_(object),
        findings_(findings),
        started_(SubtreePoses(object.bodies, 0)),
        zero_(ZeroPoses(object.bodies)) {
    for (const Body& body : object.bodies) {
      for (const Joint& joint : body.joints) joints_.emplace(joint.name, &joint);
    }
  }

  void Check(const Element& equality) {
    const Attribute* active = Given(equality, "active");
    if (active != nullptr && active->text == "false") return;
    if (equality.tag == "joint") CheckJoint(equality);
    if (equality.tag == "connect" || equality.tag == "weld") CheckBodies(equality);
  }

 private:
  const Joint* JointOf(const Element& equality, std::string_view key) const {
    const Attribute* name = Given(equality, key);
    const auto found = name == nullptr ? joints_.end() : joints_.find(name->text);
    return found == joints_.end() ? nullptr : found->second;
  }

  // Returns how far a hinge or slide is from its zero at the start; 0 for no joint.
  static double DisplacementOf(const Joint* joint) {
    if (joint == nullptr || joint->start.size() != 1) return 0;
    return joint->start[0] - ZeroPosition(*joint)[0];
  }

  void CheckJoint(const Element& equality) {
    const Joint* first = JointOf(equality, "joint1");
    const Joint* second = JointOf(equality, "joint2");
    const bool is_started = (first != nullptr && !first->start.empty()) ||
                            (second != nullptr && !second->start.empty());
    if (first == nullptr || first->type == "ball" || !is_started) return;
    constexpr double kDefaults[] = {0, 1, 0, 0, 0};
    const Attribute* given = Given(equality, "polycoef");
    const double x = DisplacementOf(second);
    double wanted = 0;
    for (std::size_t i = second == nullptr ? 1 : 5; i-- > 0;) {
      const bool is_given = given != nullptr && i < given->numbers.size();
      wanted = wanted * x + (is_given ? given->numbers[i] : kDefaults[i]);
    }
    const bool is_slide = first->type == "slide";
    Report(equality, std::abs(DisplacementOf(first) - wanted), is_slide,
           fmt::format("joint {} belongs at {}", Quoted(first->name),
                       expr::NumberText(ZeroPosition(*first)[0] + wanted)));
  }

  // Returns X_WB of the body that an attribute names; the identity for the world.
  static Pose PoseOf(const Element& equality, std::string_view key, const std::vector<Pose>& poses,
                     const std::vector<Body>& bodies) {
    const Attribute* name = Given(equality, key);
    if (name == nullptr) return {};
    const auto body = std::ranges::find(bodies, name->text, &Body::name);
    return body == bodies.end() ? Pose() : poses[static_cast<std::size_t>(body - bodies.begin())];
  }

  // Returns the pose of the second body in the first one.
  Pose RelativePose(const Element& equality, const std::vector<Pose>& poses) const {
    return PoseOf(equality, "body1", poses, object_.bodies).Inverse() *
           PoseOf(equality, "body2", poses, object_.bodies);
  }

  // A connect holds its anchor, a point of the first body, together. A weld has an anchor in the
  // second body, and also keeps the orientation.
  void CheckBodies(const Element& equality) {
    const Pose X_12 = RelativePose(equality, started_);
    const Pose zero = RelativePose(equality, zero_);
    Pose wanted = zero;
    Eigen::Vector3d anchor = PointOf(equality, "anchor");
    const Attribute* relpose = Given(equality, "relpose");
    if (equality.tag == "connect") {
      anchor = zero.Inverse() * anchor;
    } else if (relpose != nullptr && relpose->numbers.size() == 7) {
      const auto& n = relpose->numbers;
      const Eigen::Quaterniond q(n[3], n[4], n[5], n[6]);
      if (q.norm() > 0) wanted = {Eigen::Vector3d(n.data()), q.normalized()};
    }
    if (Distance(X_12, zero, anchor) + X_12.q.angularDistance(zero.q) < 1e-9) return;  // not moved
    const Attribute* torque = Given(equality, "torquescale");
    const bool keeps_turn = equality.tag == "weld" && (torque == nullptr || torque->numbers[0] > 0);
    const std::string hint = "give the joints of both bodies their starts";
    Report(equality, Distance(X_12, wanted, anchor), true, hint);
    if (keeps_turn) Report(equality, X_12.q.angularDistance(wanted.q), false, hint);
  }

  static double Distance(const Pose& a, const Pose& b, const Eigen::Vector3d& point) {
    return (a * point - b * point).norm();
  }

  void Report(const Element& equality, double amount, bool is_length, std::string hint) {
    if (amount <= (is_length ? kLengthTolerance : kAngleTolerance)) return;
    const std::string text = is_length ? expr::RoundedText(1000 * amount, 3) + " mm"
                                       : expr::RoundedText(amount, 3) + " rad";
    findings_.Add(Code::kModelBadStart, equality.mark,
                  fmt::format("the start violates equality {} by {}", Quoted(equality.name), text),
                  std::move(hint));
  }

  const Object& object_;
  diag::Findings& findings_;
  std::vector<Pose> started_;  // X_WB at the start
  std::vector<Pose> zero_;     // X_WB with all joints at zero
  std::map<std::string_view, const Joint*> joints_;
};

}  // namespace

void CheckEqualities(const Object& object, diag::Findings& findings) {
  const std::span<const Element> equalities = ElementsOf(object, "equality");
  const auto is_started = [](const Body& body) {
    return std::ranges::any_of(body.joints,
                               [](const Joint& joint) { return !joint.start.empty(); });
  };
  if (equalities.empty() || std::ranges::none_of(object.bodies, is_started)) return;
  EqualityChecker checker(object, findings);
  for (const Element& equality : equalities) checker.Check(equality);
}

}  // namespace mjforge::model
