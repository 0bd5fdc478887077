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

void ReportViolation(const Element& equality, double amount, bool is_length, std::string hint,
                     diag::Findings& findings) {
  if (amount <= (is_length ? kLengthTolerance : kAngleTolerance)) return;
  const std::string text = is_length ? expr::RoundedText(1000 * amount, 3) + " mm"
                                     : expr::RoundedText(amount, 3) + " rad";
  findings.Add(diag::Code::kModelBadStart, equality.mark,
               fmt::format("the start violates equality '{}' by {}", equality.name, text),
               std::move(hint));
}

void CheckJointEquality(const Configurations& configurations, const Element& equality,
                        diag::Findings& findings) {
  const Joint* first = configurations.FindJoint(TextOf(equality, "joint1"));
  const Joint* second = configurations.FindJoint(TextOf(equality, "joint2"));
  const bool is_started =
      (first != nullptr && HasStart(*first)) || (second != nullptr && HasStart(*second));
  if (first == nullptr || first->type == "ball" || !is_started) return;
  const sample::Numbers c = PolynomialOf(equality);
  const double x = configurations.Displacement(TextOf(equality, "joint2"));
  double wanted = 0;
  for (std::size_t i = second == nullptr ? 1 : c.size(); i-- > 0;) wanted = wanted * x + c[i];
  const double amount = std::abs(configurations.Displacement(first->name) - wanted);
  ReportViolation(equality, amount, first->type == "slide",
                  fmt::format("joint '{}' belongs at {} {}", first->name,
                              expr::NumberText(model::ZeroPosition(*first)[0] + wanted),
                              first->type == "slide" ? "m" : "rad"),
                  findings);
}

// Reports a connect or weld that the start violates. The anchor of a connect is a point of body
// 1, that of a weld a point of body 2; a weld also fixes the orientation.
void CheckBodies(const Configurations& configurations, const Element& equality,
                 diag::Findings& findings) {
  const Pose X_12 = configurations.RelativePose(equality, configurations.start());
  const Pose zero = configurations.RelativePose(equality, configurations.zero());
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
  const std::string hint = "give the joints of both bodies their starts";
  ReportViolation(equality, DistanceOf(X_12, wanted, anchor), true, hint, findings);
  if (equality.tag == "weld" && NumberOf(equality, "torquescale", 0, 1) > 0)
    ReportViolation(equality, X_12.q.angularDistance(wanted.q), false, hint, findings);
}

void CheckEquality(const Configurations& configurations, const Element& equality,
                   diag::Findings& findings) {
  if (TextOf(equality, "active") == "false") return;
  if (equality.tag == "joint") CheckJointEquality(configurations, equality, findings);
  if (equality.tag == "connect" || equality.tag == "weld")
    CheckBodies(configurations, equality, findings);
}

}  // namespace

void CheckEqualities(const model::Object& object, diag::Findings& findings) {
  const std::span<const Element> equalities = model::ElementsOf(object, "equality");
  if (equalities.empty() || !model::AnyJoint(object, model::HasStart)) return;
  const Configurations configurations(object);
  for (const Element& equality : equalities) CheckEquality(configurations, equality, findings);
}

}  // namespace mjforge::start
