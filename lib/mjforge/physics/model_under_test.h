// Model under test, and functions for names, distances and places in findings.
#pragma once

#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// A model under test, with the data and the outputs that its tests share.
struct ModelTest {
  mjModel& m;  // tests may enlarge the buffers for contacts
  Workspace& workspace;
  const model::Object& object;  // source of the model, or read from the model
  diag::SourceMark mark;        // place of findings about the whole object
  static_checks::Reporter& reporter;
  Result& result;

  const model::Checks& checks() const { return reporter.checks(); }
  std::string BodyName(int body) const;
  std::string JointName(int joint) const;
  /// Returns a distance between two positions of a joint as text: "30 deg" for rotations, "5 mm"
  /// for slides.
  std::string Distance(int joint, double distance) const;

  /// Returns the part from which the geom with this name was made; null if there is none.
  const model::Part* PartOf(std::string_view geom) const;
  // The functions below return the place of an element in the spec; `mark` if the object has no
  // such element, or if the element has no place. Names include the prefix of the object.
  diag::SourceMark PartMark(const model::Part* part) const;
  diag::SourceMark BodyMark(std::string_view name) const;
  diag::SourceMark JointMark(std::string_view name) const;
  /// `section` is the section of MJCF with the element, such as "actuator".
  diag::SourceMark ElementMark(std::string_view section, std::string_view name) const;
};

}  // namespace mjforge::physics
