// Rewrites equality constraints that MuJoCo measures from the zero configuration (qpos0).
#include <algorithm>
#include <cstddef>

#include "mjforge/start/rewriting.h"

namespace mjforge::start {
namespace {

using model::Element;
using model::Pose;

// Returns the coefficients of an equality's polynomial y = c(x) after the zeros of x and y have
// moved by `dx` and `dy`. Without a second joint or tendon (`has_x` is false), only the constant
// c[0] changes.
sample::Numbers Shifted(const sample::Numbers& c, bool has_x, double dx, double dy) {
  sample::Numbers shifted = c;
  for (std::size_t k = 0; has_x && k < c.size(); ++k) {
    shifted[k] = 0;
    double binomial = 1;  // i choose k
    double power = 1;     // dx^(i - k)
    for (std::size_t i = k; i < c.size(); ++i) {
      shifted[k] += binomial * c[i] * power;
      binomial *= static_cast<double>(i + 1) / static_cast<double>(i + 1 - k);
      power *= dx;
    }
  }
  shifted[0] -= dy;
  return shifted;
}

void ShiftPolynomial(bool has_x, double dx, double dy, Element& equality) {
  if (dx == 0 && dy == 0) return;
  SetNumbers(equality.attributes, "polycoef", Shifted(PolynomialOf(equality), has_x, dx, dy));
}

void SetRelativePose(const Eigen::Vector3d& p, const Eigen::Quaterniond& q, Element& weld) {
  SetNumbers(weld.attributes, "relpose", {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
}

bool IsSame(const Pose& a, const Pose& b) {
  const Pose X_AB = a.Inverse() * b;
  return X_AB.p.norm() <= kRounding && !IsTurned(X_AB.q);
}

double LengthChange(const Configurations& configurations, std::string_view name) {
  const Element* tendon = configurations.FindTendon(name);
  if (tendon == nullptr) return 0;
  const bool changes =
      tendon->tag == "fixed" ||
      configurations.ChangesPath(*tendon, configurations.zero(), configurations.start());
  return changes ? configurations.LengthChange(*tendon) : 0;
}

void RewriteJointEquality(const Configurations& configurations, Element& equality) {
  const std::string_view second = TextOf(equality, "joint2");
  ShiftPolynomial(!second.empty(), configurations.Displacement(second),
                  configurations.Displacement(TextOf(equality, "joint1")), equality);
}

void RewriteTendonEquality(const Configurations& configurations, Element& equality) {
  const std::string_view second = TextOf(equality, "tendon2");
  ShiftPolynomial(!second.empty(), LengthChange(configurations, second),
                  LengthChange(configurations, TextOf(equality, "tendon1")), equality);
}

// Writes `relpose` of a weld if it is missing or its quaternion is zero, because MuJoCo then
// takes the relative pose at zero. The position in `relpose` is that of the anchor in body 1,
// whereas `anchor` is in body 2.
void RewriteWeld(const Configurations& configurations, Element& weld) {
  const sample::Numbers given = NumbersOf(weld.attributes, "relpose");
  if (given.size() == 7 &&
      std::any_of(given.begin() + 3, given.end(), [](double number) { return number != 0; })) {
    return;
  }
  const Pose X_12 = configurations.RelativePose(weld, configurations.zero());
  if (IsSame(X_12, configurations.RelativePose(weld, configurations.start()))) return;
  SetRelativePose(X_12 * VectorOf(weld, "anchor"), X_12.q, weld);
}

// Turns a connect that is open at the start into a weld with torquescale 0. MuJoCo computes the
// second anchor of a connect from the zero configuration, but a weld states both anchors.
void RewriteConnect(const Configurations& configurations, Element& connect) {
  const Eigen::Vector3d p_1A = VectorOf(connect, "anchor");
  const Pose X_12 = configurations.RelativePose(connect, configurations.zero());
  const Eigen::Vector3d p_2A = X_12.Inverse() * p_1A;
  const Eigen::Vector3d gap =
      configurations.RelativePose(connect, configurations.start()) * p_2A - p_1A;
  if (gap.norm() <= kRounding) return;
  connect.tag = "weld";
  SetNumbers(connect.attributes, "anchor", p_2A);
  SetRelativePose(p_1A, X_12.q, connect);
  SetNumbers(connect.attributes, "torquescale", {0.0});
}

void RewriteEquality(const Configurations& configurations, Element& equality) {
  if (equality.tag == "joint") RewriteJointEquality(configurations, equality);
  if (equality.tag == "tendon") RewriteTendonEquality(configurations, equality);
  if (equality.tag == "weld") RewriteWeld(configurations, equality);
  if (equality.tag == "connect") RewriteConnect(configurations, equality);
}

}  // namespace

void RewriteEqualities(const Configurations& configurations, model::Object& object) {
  for (model::Section& section : object.sections) {
    if (section.info->name != "equality") continue;
    for (Element& equality : section.elements) RewriteEquality(configurations, equality);
  }
}

}  // namespace mjforge::start
