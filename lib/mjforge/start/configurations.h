// Configurations of an object before its zero configuration changes, and its elements by name.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::start {

/// X_WB of every body.
using Poses = std::vector<model::Pose>;

/// Lengths and rotations up to this size, m or rad, are rounding errors.
inline constexpr double kRounding = 1e-12;

/// Returns the numbers of an attribute; none if the element does not have the attribute.
template <typename Attributes>
sample::Numbers NumbersOf(const Attributes& attributes, std::string_view name) {
  const auto* attribute = model::FindAttribute(attributes, name);
  return attribute == nullptr ? sample::Numbers() : attribute->numbers;
}
/// Returns the text of an attribute; empty if the element does not have the attribute.
std::string_view TextOf(const model::Element& element, std::string_view name);
/// Sets the numbers of an attribute, which is added if it is missing. `name` is in static storage.
template <typename Attributes>
void SetNumbers(Attributes& attributes, std::string_view name, const sample::Numbers& numbers) {
  auto* attribute = model::FindAttribute(attributes, name);
  if (attribute == nullptr) attribute = &attributes.emplace_back();
  attribute->name = name;
  attribute->numbers = numbers;
}

/// Returns an attribute of three numbers; `otherwise` if the element does not have the attribute.
Eigen::Vector3d VectorOf(const model::Element& element, std::string_view name,
                         const Eigen::Vector3d& otherwise = Eigen::Vector3d::Zero());
/// Returns the coefficients of an equality's polynomial, of which MuJoCo's defaults may be left
/// out.
sample::Numbers PolynomialOf(const model::Element& equality);

/// Returns true if any joint of the object has a start position.
bool HasStart(const model::Object& object);
/// Returns true if any joint of the object starts elsewhere than at zero.
bool IsMoved(const model::Object& object);
/// Returns true if the rotation is not the identity.
bool IsTurned(const Eigen::Quaterniond& q);
inline bool IsScalar(const model::Joint& joint) {
  return joint.type == "hinge" || joint.type == "slide";
}
/// Returns D_(k+1) ... D_n for joint k of a body: the motion of the later joints from zero to the
/// start, in the frame of the body.
model::Pose MotionOfLaterJoints(const model::Body& body, std::size_t joint);

class Configurations {
 public:
  /// The object must outlive the configurations; its names and joints must not change meanwhile.
  explicit Configurations(const model::Object& object);

  const model::Object& object() const { return object_; }
  const Poses& zero() const { return zero_; }
  const Poses& start() const { return start_; }
  /// Poses at which springs of tendons are at rest (MuJoCo's qpos_spring): hinges and slides at
  /// `springref`, and ball joints at zero or, if `balls_start`, at their start.
  Poses Springs(bool balls_start) const;

  /// Returns the pose of a body; the identity for the world.
  model::Pose PoseOf(std::string_view body, const Poses& X_WB) const;
  /// Returns X_12 of the two bodies of an equality.
  model::Pose RelativePose(const model::Element& equality, const Poses& X_WB) const;
  /// Returns the joint with that name; null if there is none.
  const model::Joint* FindJoint(std::string_view name) const;
  /// Returns the distance of a hinge or slide from its zero to its start, rad or m.
  double Displacement(std::string_view name) const;
  /// Returns the element of the section `tendon` with that name; null if there is none.
  const model::Element* FindTendon(std::string_view name) const;

  /// Returns true if the tendon wraps around a geom, so that only MuJoCo computes its length.
  static bool Wraps(const model::Element& tendon);
  /// Returns true if the sites and geoms on the path of a spatial tendon have other poses relative
  /// to each other.
  bool ChangesPath(const model::Element& tendon, const Poses& from, const Poses& to) const;
  /// Returns the length of a spatial tendon without geoms on its path, m.
  double Length(const model::Element& tendon, const Poses& X_WB) const;
  /// Returns the length at the start minus the length at zero of a tendon without geoms on its
  /// path.
  double LengthChange(const model::Element& tendon) const;

 private:
  struct Site {
    std::size_t body = 0;
    Eigen::Vector3d p_BS;
  };

  const model::Object& object_;
  std::map<std::string_view, std::size_t> bodies_;
  std::map<std::string_view, const model::Joint*> joints_;
  std::map<std::string_view, Site> sites_;
  std::map<std::string_view, std::size_t> geoms_;  // body of each part
  Poses zero_;
  Poses start_;
};

}  // namespace mjforge::start
