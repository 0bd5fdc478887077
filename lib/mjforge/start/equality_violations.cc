// Check for equalities of joints, connects and welds that the start violates.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/start/configurations.h"
#include "mjforge/start/start.h"

namespace mjforge::start {
namespace {

using model::Element;
using model::Joint;
using model::Pose;

constexpr double kLengthTolerance = 1e-4;                    // m
constexpr double kAngleTolerance = std::numbers::pi / 1800;  // rad
constexpr double kUnmoved = 1e-9;                            // m or rad; less is a rounding error

double DistanceOf(const Pose& a, const Pose& b, const Eigen::Vector3d& point) {
  return (a * point - b * point).norm();
}

class ViolationFinder {
 public:
  ViolationFinder(const Configurations& configurations, diag::Findings& findings)
      : configurations_(configurations), findings_(findings) {}

  void Check(const Element& equality) {
    if (TextOf(equality, "active") == "false") return;
    if (equality.tag == "joint") CheckJoint(equality);
    if (equality.tag == "connect" || equality.tag == "weld") CheckBodies(equality);
  }

 private:
  void CheckJoint(const Element& equality) {
    const Joint* first = configurations_.FindJoint(TextOf(equality, "joint1"));
    const Joint* second = configurations_.FindJoint(TextOf(equality, "joint2"));
    const bool is_started = (first != nullptr && !first->start.empty()) ||
                            (second != nullptr && !second->start.empty());
    if (first == nullptr || first->type == "ball" || !is_started) return;
    const sample::Numbers c = PolynomialOf(equality);
    const double x = configurations_.Displacement(TextOf(equality, "joint2"));
    double wanted = 0;
    for (std::size_t i = second == nullptr ? 1 : c.size(); i-- > 0;) wanted = wanted * x + c[i];
    const double amount = std::abs(configurations_.Displacement(first->name) - wanted);
    Report(equality, amount, first->type == "slide",
           fmt::format("joint '{}' belongs at {} {}", first->name,
                       expr::NumberText(model::ZeroPosition(*first)[0] + wanted),
                       first->type == "slide" ? "m" : "rad"));
  }

  // Reports a connect or weld that the start violates. The anchor of a connect is a point of body
  // 1, that of a weld a point of body 2; a weld also fixes the orientation.
  void CheckBodies(const Element& equality) {
    const Pose X_12 = configurations_.RelativePose(equality, configurations_.start());
    const Pose zero = configurations_.RelativePose(equality, configurations_.zero());
    Pose wanted = zero;
    Eigen::Vector3d anchor = VectorOf(equality, "anchor");
    const sample::Numbers relpose = NumbersOf(equality.attributes, "relpose");
    if (equality.tag == "connect") {
      anchor = zero.Inverse() * anchor;
    } else if (relpose.size() == 7) {
      const Eigen::Quaterniond q(relpose[3], relpose[4], relpose[5], relpose[6]);
      // The position in `relpose` is that of the anchor in body 1.
      if (q.norm() > 0) {
        wanted.q = q.normalized();
        wanted.p = Eigen::Vector3d(relpose.data()) - wanted.q * anchor;
      }
    }
    if (DistanceOf(X_12, zero, anchor) + X_12.q.angularDistance(zero.q) < kUnmoved) return;
    const sample::Numbers torque = NumbersOf(equality.attributes, "torquescale");
    const std::string hint = "give the joints of both bodies their starts";
    Report(equality, DistanceOf(X_12, wanted, anchor), true, hint);
    if (equality.tag == "weld" && (torque.empty() || torque[0] > 0))
      Report(equality, X_12.q.angularDistance(wanted.q), false, hint);
  }

  void Report(const Element& equality, double amount, bool is_length, std::string hint) {
    if (amount <= (is_length ? kLengthTolerance : kAngleTolerance)) return;
    const std::string text = is_length ? expr::RoundedText(1000 * amount, 3) + " mm"
                                       : expr::RoundedText(amount, 3) + " rad";
    findings_.Add(diag::Code::kModelBadStart, equality.mark,
                  fmt::format("the start violates equality '{}' by {}", equality.name, text),
                  std::move(hint));
  }

  const Configurations& configurations_;
  diag::Findings& findings_;
};

}  // namespace

void CheckEqualities(const model::Object& object, diag::Findings& findings) {
  const std::span<const Element> equalities = model::ElementsOf(object, "equality");
  if (equalities.empty() || !model::AnyJoint(object, model::HasStart)) return;
  const Configurations configurations(object);
  ViolationFinder finder(configurations, findings);
  for (const Element& equality : equalities) finder.Check(equality);
}

}  // namespace mjforge::start
