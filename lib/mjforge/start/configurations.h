// Poses of an object's bodies at the zero configuration (qpos0), at the start and where the springs
// rest; displacements of joints, and lengths of tendons between these configurations.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::start {

/// World poses X_WB of all bodies, in the order of Object::bodies.
using Poses = std::vector<model::Pose>;

/// Lengths and rotations up to this size, m or rad, are rounding errors.
inline constexpr double kRounding = 1e-12;

/// Returns the numbers of an attribute; an empty list if the element does not have the attribute.
template <typename Attributes>
sample::Numbers NumbersOf(const Attributes& attributes, std::string_view name) {
  const auto* attribute = model::FindAttribute(attributes, name);
  if (attribute == nullptr) return {};
  return {attribute->numbers.begin(), attribute->numbers.end()};
}
/// Returns the five coefficients of an equality's polynomial (`polycoef`); MuJoCo's default for
/// each coefficient that is missing.
sample::Numbers PolynomialOf(const model::Element& equality);

/// Returns true if the start position of any joint differs from the joint's zero position.
bool IsMoved(const model::Object& object);
/// Returns true if the rotation is not the identity.
bool IsTurned(const Eigen::Quaterniond& q);
inline bool IsScalar(const model::Joint& joint) {
  return joint.type == "hinge" || joint.type == "slide";
}
/// Returns the motion, from zero to the start, of all joints of a body after joint k = `joint`, in
/// the frame of the body: the product D_(k+1) ... D_n of the joints' motions.
model::Pose MotionOfLaterJoints(const model::Body& body, std::size_t joint);

/// Poses of an object at its zero configuration and at its start, and lookup of its elements.
class Configurations {
 public:
  /// Stores a reference to the object. The object's names and joints must not change while this
  /// Configurations exists.
  explicit Configurations(const model::Object& object);

  const model::Object& object() const { return object_; }
  const Poses& zero() const { return zero_; }
  const Poses& start() const { return start_; }
  /// Returns the poses at which springs of tendons are at rest (MuJoCo's qpos_spring): hinges and
  /// slides at `springref`, and ball joints at zero or, if `balls_start`, at their start.
  Poses Springs(bool balls_start) const;

  /// Returns the pose of a body; the identity for the world.
  model::Pose PoseOf(std::string_view body, const Poses& X_WB) const;
  /// Returns X_12, the pose of body 2 in the frame of body 1, for the bodies of an equality.
  model::Pose RelativePose(const model::Element& equality, const Poses& X_WB) const;
  /// Returns the joint with this name; null if there is none.
  const model::Joint* FindJoint(std::string_view name) const;
  /// Returns the displacement of a hinge or slide from its zero to its start, rad or m; 0 for any
  /// other name, and if the joint has no start position.
  double Displacement(std::string_view name) const;
  /// Returns the element of the section `tendon` with this name; null if there is none.
  const model::Element* FindTendon(std::string_view name) const;

  /// Returns true if the tendon wraps around a geom, so that only MuJoCo computes its length.
  static bool Wraps(const model::Element& tendon);
  /// Returns true if the sites and geoms on the path of a spatial tendon move relative to each
  /// other between the poses `from` and `to`.
  bool ChangesPath(const model::Element& tendon, const Poses& from, const Poses& to) const;
  /// Returns the length of a spatial tendon without geoms on its path, m.
  double Length(const model::Element& tendon, const Poses& X_WB) const;
  /// Returns the length of a tendon at the start minus its length at zero. The tendon must not wrap
  /// around a geom.
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
  std::map<std::string_view, std::size_t> geoms_;  // index of the body of each part
  Poses zero_;
  Poses start_;
};

}  // namespace mjforge::start
