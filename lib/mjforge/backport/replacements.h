// Replaces attributes of later MuJoCo releases by equivalent older ones.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/backport/default_classes.h"

namespace mjforge::backport {

/// Replaces attributes that are newer than the release `version` (a mjVERSION_HEADER) by older
/// attributes with exactly the same meaning, where such attributes exist.
class Replacements {
 public:
  Replacements(DefaultClasses& elements, int version) : elements_(elements), version_(version) {}

  /// Makes all replacements.
  void Run();
  /// Returns an empty text if Run() replaced the attribute (or the element, if `attribute` is
  /// empty). Returns the reason if the attribute has no effect in this file. Otherwise returns
  /// nullopt.
  std::optional<std::string_view> Find(const xml::XmlElement* element,
                                       std::string_view attribute) const;

 private:
  /// Returns the value of an attribute that the element or its default classes set; null if the
  /// attribute is not set, or if the release `version` has the attribute.
  const std::string* FindMissing(const ClassedElement& classed, std::string_view attribute) const;
  /// Stores for Find() that an attribute is replaced or, if `why_neutral` is not empty, has no
  /// effect for this reason.
  void MarkReplaced(ClassedElement& classed, std::string_view attribute,
                    std::string_view why_neutral = {});

  // Defined in actuator_replacements.cc.
  void ReplaceDamping(ClassedElement& servo);
  void ReplaceInheritedRange(ClassedElement& actuator);
  void ReplaceJointForceRange(ClassedElement& joint, std::string_view range,
                              std::string_view limited);
  /// Returns the actuators whose transmission is the joint itself; nullopt if further actuators may
  /// move the joint, for example by a tendon.
  std::optional<std::vector<ClassedElement*>> ActuatorsOf(const std::string& joint);
  /// Intersects the actuator's force range with a range of joint forces; returns false if no force
  /// remains or if the gear is 0.
  bool LimitForce(ClassedElement& actuator, std::vector<double> range);

  void ReplaceAssetFolder(ClassedElement& compiler);
  void ReplaceLightType(ClassedElement& light);
  void ReplaceSensorSize(ClassedElement& camera);
  void ReplaceColorLayer(ClassedElement& material);
  void ReplaceMeshInertia(ClassedElement& mesh);
  /// Returns true if a geom's mass is computed from the mesh.
  bool HasMass(const std::string& mesh);
  /// Returns true if this build can compute the masses of all geoms that use the mesh by the rule
  /// that `inertia` of the mesh sets.
  bool CanComputeMasses(const std::string& mesh);

  DefaultClasses& elements_;
  int version_;
  std::map<std::pair<const xml::XmlElement*, std::string>, std::string_view> replaced_;
};

}  // namespace mjforge::backport
