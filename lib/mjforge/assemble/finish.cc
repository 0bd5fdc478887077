// Last step of an assembly: checks of the whole object, its mass and bounds, start positions.

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/free_bodies.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/setpoints.h"
#include "mjforge/assemble/shown_pose.h"
#include "mjforge/assemble/views.h"
#include "mjforge/model/model.h"
#include "mjforge/start/start.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// MuJoCo's mjMINVAL: a body that moves must have a larger mass.
constexpr double kSmallestMass = 1e-15;

// Reports bodies that have joints but no mass. Requires an earlier call of ShareMass(), which gives
// such bodies mass from children that are fixed to them.
void CheckMass(const model::Object& object, diag::Findings& findings) {
  for (const model::Body& body : object.bodies) {
    if (body.joints.empty() || body.mass_properties.mass > kSmallestMass) continue;
    if (body.parent < 0) {
      findings.Add(Code::kModelNoMass, body.mark,
                   fmt::format("object '{}' can move but has no mass", object.name),
                   "give a part a mass, or write `joints: none`");
    } else {
      findings.Add(Code::kModelNoMass, body.mark,
                   fmt::format("body '{}' can move but has no mass", body.name),
                   "give one of its parts a mass, or remove its joints");
    }
  }
}

}  // namespace

void Assembly::Finish(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (part_count_ == 0) {
    const diag::SourceMark mark = !spec.parts.empty()    ? spec.parts.front().mark
                                  : !spec.bodies.empty() ? spec.bodies.front().head.mark
                                                         : spec.mark;
    findings_.Add(Code::kModelNoParts, mark, "no part is left",
                  spec.parts.empty() && spec.bodies.empty()
                      ? "write something into `parts:` or `bodies:`"
                      : "every part is left out by its 'if' or 'for'");
    return;
  }
  assets_.CheckPixels();
  SearchFaces(0);
  CheckLevelRegions(object_, spec_->mark, findings_);
  CheckUniqueNames(object_, findings_);
  references_.Check();
  couplings_.CheckLeaders(object_, findings_);
  CheckViews(object_, findings_);
  CheckShownPose(spec, object_, findings_);
  ReportLostStarts();
  assets_.SumMass(object_.bodies.front());
  object_.mass_properties = model::SubtreeMass(object_.bodies, 0);
  model::ShareMass(object_.bodies);
  CheckMass(object_, findings_);
  object_.bounds = scope.total_size ? model::DeclaredBounds(*scope.total_size)
                                    : model::SubtreeBounds(object_.bodies, 0);
  ReleaseFreeBodies(object_.bodies, findings_);
  object_.bounds.swept = model::SweptBounds(object_);
  AddExpectations(scope);
  std::ranges::sort(object_.sections, {}, &model::Section::info);
  for (model::Section& section : object_.sections) {
    // MuJoCo 2.2 requires that actuators with an activation state come last.
    if (section.info->name == "actuator")
      std::stable_partition(section.elements.begin(), section.elements.end(),
                            std::not_fn(HasActivation));
  }
  CompleteSetpoints(object_, findings_);
  start::CheckEqualities(object_, findings_);
}

}  // namespace mjforge::assemble
