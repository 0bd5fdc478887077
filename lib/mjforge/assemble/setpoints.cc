// Completes the setpoints of actuators at the start: values of the spec, and positions that servos
// hold.

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/setpoints.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Returns the hinge or slide that an actuator moves, if that joint has a start position; otherwise
// null.
const model::Joint* StartedJoint(const model::Object& object, const model::Element& actuator) {
  const std::string_view name =
      TextOf(actuator, "joint", TextOf(actuator, "jointinparent", std::string_view()));
  const model::Joint* joint = model::FindJoint(object, name);
  return joint != nullptr && joint->start.size() == 1 ? joint : nullptr;
}

// Returns the input at which a position servo exerts no force if the length of its transmission is
// `length`. Returns nullopt for other actuators. Source: mj_fwdActuation of MuJoCo 2.2
// (src/engine/engine_forward.c).
std::optional<double> HoldingInput(const model::Element& actuator, double length) {
  if (actuator.tag == "position" || actuator.tag == "intvelocity") return length;
  if (actuator.tag != "general" || TextOf(actuator, "gaintype", "fixed") != "fixed" ||
      TextOf(actuator, "biastype", "none") != "affine")
    return std::nullopt;
  const double gain = NumberOf(actuator, "gainprm", 0, 1);
  const double slope = NumberOf(actuator, "biasprm", 1, 0);
  if (!(gain * slope < 0)) return std::nullopt;
  return -(NumberOf(actuator, "biasprm", 0, 0) + slope * length) / gain;
}

// Sets the numbers of a servo's setpoint that the spec does not specify, so that the servo holds
// its joint at the start.
void SetHolding(const model::Object& object, const model::Element& actuator,
                model::Setpoint& setpoint) {
  const model::Joint* joint = StartedJoint(object, actuator);
  if (joint == nullptr) return;
  const double length = NumberOf(actuator, "gear", 0, 1) * joint->start[0];
  const std::optional<double> input = HoldingInput(actuator, length);
  if (!input) return;
  const bool is_integrator =
      actuator.tag == "intvelocity" || TextOf(actuator, "dyntype", "none") == "integrator";
  if (HasActivation(actuator) && !setpoint.act) setpoint.act = input;
  if (!is_integrator && !setpoint.ctrl) setpoint.ctrl = input;
}

void CheckRange(const model::Element& actuator, std::string_view what, double number,
                const model::Setpoint& setpoint, diag::Findings& findings) {
  const std::string range = fmt::format("{}range", what);
  const model::Attribute* limits = model::FindAttribute(actuator.attributes, range);
  if (limits == nullptr || limits->numbers.size() != 2 ||
      TextOf(actuator, fmt::format("{}limited", what), "true") == "false")
    return;
  const double slack = 1e-9 * (limits->numbers[1] - limits->numbers[0]);
  if (number >= limits->numbers[0] - slack && number <= limits->numbers[1] + slack) return;
  findings.Add(
      Code::kModelBadStart, setpoint.mark ? setpoint.mark : actuator.mark,
      fmt::format("{} of actuator {} is {} at the start, outside its {} {} .. {}", what,
                  Quoted(actuator.name), expr::NumberText(number), range,
                  expr::NumberText(limits->numbers[0]), expr::NumberText(limits->numbers[1])),
      setpoint.mark ? ""
                    : fmt::format("the servo cannot hold its joint at the start; give it "
                                  "another `{}` in a list under `pose:`",
                                  what));
}

}  // namespace

bool HasActivation(const model::Element& actuator) {
  constexpr std::string_view kStateful[] = {"intvelocity", "cylinder", "muscle"};
  if (std::ranges::find(kStateful, actuator.tag) != std::end(kStateful)) return true;
  return TextOf(actuator, "dyntype", "none") != "none";
}

void CompleteSetpoints(model::Object& object, diag::Findings& findings) {
  const std::vector<model::Setpoint> given = std::exchange(object.setpoints, {});
  bool all_zero = true;
  for (const model::Element& actuator : model::ElementsOf(object, "actuator")) {
    const auto found = std::ranges::find(given, actuator.name, &model::Setpoint::actuator);
    model::Setpoint setpoint = found == given.end() ? model::Setpoint{} : *found;
    setpoint.actuator = actuator.name;
    if (setpoint.act && !HasActivation(actuator)) {
      findings.Add(Code::kModelBadStart, setpoint.mark,
                   fmt::format("actuator {} has no activation for `act`", Quoted(actuator.name)),
                   "set its `ctrl`");
    }
    SetHolding(object, actuator, setpoint);
    if (setpoint.ctrl) CheckRange(actuator, "ctrl", *setpoint.ctrl, setpoint, findings);
    if (setpoint.act) CheckRange(actuator, "act", *setpoint.act, setpoint, findings);
    if (HasActivation(actuator) && !setpoint.act) setpoint.act = 0;
    all_zero &= setpoint.ctrl.value_or(0) == 0 && setpoint.act.value_or(0) == 0;
    object.setpoints.push_back(std::move(setpoint));
  }
  if (all_zero) object.setpoints.clear();
}

}  // namespace mjforge::assemble
