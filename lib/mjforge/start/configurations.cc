// Poses of an object's bodies at the zero configuration (qpos0) and at the start, and the object's
// joints, sites and tendons by name.
#include "mjforge/start/configurations.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace mjforge::start {

using model::Pose;

namespace {

// Returns the name of the part that a geom belongs to.
std::string_view PartOf(std::string_view geom) {
  if (geom.ends_with(model::kVisualSuffix)) geom.remove_suffix(model::kVisualSuffix.size());
  return geom;
}

}  // namespace

sample::Numbers PolynomialOf(const model::Element& equality) {
  constexpr std::array<double, 5> kDefaults = {0, 1, 0, 0, 0};
  sample::Numbers c = NumbersOf(equality.attributes, "polycoef");
  for (std::size_t i = c.size(); i < kDefaults.size(); ++i) c.push_back(kDefaults[i]);
  return c;
}

bool IsMoved(const model::Object& object) {
  return model::AnyJoint(object, [](const model::Joint& joint) {
    return HasStart(joint) && joint.start != model::ZeroPosition(joint);
  });
}

bool IsTurned(const Eigen::Quaterniond& q) { return q.vec().norm() > kRounding; }

Pose MotionOfLaterJoints(const model::Body& body, std::size_t joint) {
  Pose motion;
  for (std::size_t i = joint + 1; i < body.joints.size(); ++i)
    motion = motion * model::JointMotion(body.joints[i], {}, body.joints[i].start);
  return motion;
}

Configurations::Configurations(const model::Object& object) : object_(object) {
  std::vector<std::pair<std::string, sample::Numbers>> zero;
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const model::Body& body = object.bodies[i];
    bodies_.emplace(body.name, i);
    for (const model::Joint& joint : body.joints) {
      joints_.emplace(joint.name, &joint);
      if (!joint.start.empty()) zero.emplace_back(joint.name, model::ZeroPosition(joint));
    }
    for (const model::Site& site : body.sites) sites_.emplace(site.name, Site{i, site.X_BS.p});
    for (const model::Part& part : body.parts) geoms_.emplace(part.name, i);
  }
  zero_ = model::SubtreePoses(object.bodies, 0, zero);
  start_ = model::SubtreePoses(object.bodies, 0);
}

Poses Configurations::Springs(bool balls_start) const {
  std::vector<std::pair<std::string, sample::Numbers>> positions;
  for (const auto& [name, joint] : joints_) {
    if (IsScalar(*joint)) {
      sample::Numbers rest = NumbersOf(joint->attributes, "springref");
      positions.emplace_back(name, rest.empty() ? sample::Numbers{0.0} : std::move(rest));
    } else if (!joint->start.empty() && !balls_start) {
      positions.emplace_back(name, model::ZeroPosition(*joint));
    }
  }
  return model::SubtreePoses(object_.bodies, 0, positions);
}

Pose Configurations::PoseOf(std::string_view body, const Poses& X_WB) const {
  const auto found = bodies_.find(body);
  return found == bodies_.end() ? Pose() : X_WB[found->second];
}

Pose Configurations::RelativePose(const model::Element& equality, const Poses& X_WB) const {
  return PoseOf(TextOf(equality, "body1"), X_WB).Inverse() *
         PoseOf(TextOf(equality, "body2"), X_WB);
}

const model::Joint* Configurations::FindJoint(std::string_view name) const {
  const auto found = joints_.find(name);
  return found == joints_.end() ? nullptr : found->second;
}

double Configurations::Displacement(std::string_view name) const {
  const model::Joint* joint = FindJoint(name);
  if (joint == nullptr || joint->start.size() != 1) return 0;
  return joint->start[0] - model::ZeroPosition(*joint)[0];
}

const model::Element* Configurations::FindTendon(std::string_view name) const {
  return diag::Find(model::ElementsOf(object_, "tendon"), name, &model::Element::name);
}

bool Configurations::Wraps(const model::Element& tendon) {
  return std::ranges::count(tendon.children, "geom", &model::Element::tag) > 0;
}

bool Configurations::ChangesPath(const model::Element& tendon, const Poses& from,
                                 const Poses& to) const {
  std::optional<std::size_t> first;
  for (const model::Element& child : tendon.children) {
    const auto site = sites_.find(TextOf(child, "site"));
    const auto geom = geoms_.find(PartOf(TextOf(child, "geom")));
    if (site == sites_.end() && geom == geoms_.end()) continue;
    const std::size_t body = site != sites_.end() ? site->second.body : geom->second;
    if (!first) first = body;
    const Pose X_1B = from[*first].Inverse() * from[body];
    const Pose change = X_1B.Inverse() * (to[*first].Inverse() * to[body]);
    if (change.p.norm() > kRounding || IsTurned(change.q)) return true;
  }
  return false;
}

// Follows mj_tendon of MuJoCo 2.2 (src/engine/engine_core_smooth.c): a pulley begins a new branch,
// and the length of a branch is divided by the `divisor` of its pulley.
double Configurations::Length(const model::Element& tendon, const Poses& X_WB) const {
  double length = 0;
  double divisor = 1;
  const Site* last = nullptr;
  for (const model::Element& child : tendon.children) {
    if (child.tag == "pulley") {
      divisor = NumberOf(child, "divisor", 0, divisor);
      last = nullptr;
      continue;
    }
    const auto site = sites_.find(TextOf(child, "site"));
    if (site == sites_.end()) continue;
    if (last != nullptr) {
      const Eigen::Vector3d from = X_WB[last->body] * last->p_BS;
      length += (X_WB[site->second.body] * site->second.p_BS - from).norm() / divisor;
    }
    last = &site->second;
  }
  return length;
}

double Configurations::LengthChange(const model::Element& tendon) const {
  if (tendon.tag != "fixed") return Length(tendon, start_) - Length(tendon, zero_);
  double change = 0;
  for (const model::Element& child : tendon.children) {
    change += NumberOf(child, "coef", 0, 0) * Displacement(TextOf(child, "joint"));
  }
  return change;
}

}  // namespace mjforge::start
