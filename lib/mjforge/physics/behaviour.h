#pragma once

#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/physics/drive.h"
#include "mjforge/physics/settle.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Simulates a model and says what is not as it should be. `object` is what the
/// model was made from, or read into; `mark` is for findings of the whole. Changes
/// the model's room for contacts.
class Behaviour {
 public:
  Behaviour(mjModel& m, Workspace& workspace, const model::Object& object, diag::SourceMark mark,
            Verdict& verdict)
      : m_(m), workspace_(workspace), object_(object), mark_(mark), verdict_(verdict) {}

  /// Fills in everything except the overlap. May throw std::exception.
  void Check(Result& result);

 private:
  bool CanStep();
  Trouble Drop(Result& result);
  void ReportDrop(const Trouble& trouble, const Result& result);
  void ReportPose(const Result& result);
  void ReportJoint(const Driven& driven);
  diag::SourceMark MarkOf(std::string_view joint) const;

  mjModel& m_;
  Workspace& workspace_;
  const model::Object& object_;
  diag::SourceMark mark_;
  Verdict& verdict_;
};

}  // namespace mjforge::physics
