#ifndef MJFORGE_PHYSICS_BEHAVIOUR_H_
#define MJFORGE_PHYSICS_BEHAVIOUR_H_

#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/drive.h"
#include "mjforge/physics/settle.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/subject.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Where a joint stands in the spec.
struct JointMark {
  std::string_view name;
  diag::SourceMark mark;
};

/// Simulates a model and says what is not as it should be. Findings about joints
/// without a mark point at the subject's. Changes the model's room for contacts.
class Behaviour {
 public:
  Behaviour(mjModel& m, Workspace& workspace, const Subject& subject,
            const std::vector<JointMark>& marks, Verdict& verdict)
      : m_(m), workspace_(workspace), subject_(subject), marks_(marks), verdict_(verdict) {}

  /// Fills in all of it but the overlap. May throw std::exception.
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
  const Subject& subject_;
  const std::vector<JointMark>& marks_;
  Verdict& verdict_;
};

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_BEHAVIOUR_H_
