#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/engine/placed_elements.h"

namespace mjforge::engine {

/// Says what releases after `version` added in words that it knows, where they say exactly the
/// same.
class Rewriting {
 public:
  Rewriting(PlacedElements& elements, int version) : elements_(elements), version_(version) {}

  void Run();
  /// Whether an attribute (empty: the element) is dealt with: "" if it is said in other words now,
  /// else why it changes nothing in this file.
  std::optional<std::string_view> Find(const XmlElement* element, std::string_view attribute) const;

 private:
  /// Of the element or its default class, if the release lacks it; else null.
  const std::string* Lacking(const Placed& placed, std::string_view attribute) const;
  void Done(Placed& placed, std::string_view attribute, std::string_view why_nothing = {});

  // rewrite_actuators.cc
  void DampServo(Placed& servo);
  void InheritRange(Placed& actuator);
  void LimitJoint(Placed& joint, std::string_view range, std::string_view limited);
  /// The actuators that act on the joint; nothing if others than those of joints may.
  std::optional<std::vector<Placed*>> DriversOf(const std::string& joint);
  bool LimitForce(Placed& actuator, std::vector<double> range);

  void SetFolders(Placed& compiler);
  void AimLight(Placed& light);
  void PlaceCamera(Placed& camera);
  void LayMaterial(Placed& material);
  void WeighMesh(Placed& mesh);
  bool Weighs(const std::string& mesh);

  PlacedElements& elements_;
  int version_;
  std::map<std::pair<const XmlElement*, std::string>, std::string_view> done_;
};

}  // namespace mjforge::engine
