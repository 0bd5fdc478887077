// Reads `detent:`: sets a spring of negative stiffness, damping, armature and stiff limits.

#include "mjforge/assemble/detents.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Ratio of damping to stiffness, s: about the time in which the joint crosses its range. A faster
// joint would hit the limit at a speed that MuJoCo's usual timestep of 2 ms does not resolve.
constexpr double kSnapTime = 0.03;
// Square root of the ratio of armature to stiffness, s; it determines the armature of the joint.
// MuJoCo makes limits softer for joints with less inertia, so that without armature the spring
// would push a light body through the limit.
constexpr double kPeriod = 0.02;
// Parameters (solreflimit, solimplimit) of limits that hardly yield under the spring: as stiff as
// the usual timestep allows, with the impedance of couplings.
constexpr std::initializer_list<double> kEndReference = {0.004, 1};
constexpr std::initializer_list<double> kEndImpedance = {0.99, 0.999, 0.001, 0.5, 2};

// Returns true if a spring or a screw in the entry itself replaces a detent from the defaults.
bool HasOwnSpring(const spec::Entry& entry, const spec::Field& detent) {
  const auto is_spring = [](const spec::Field& field) {
    return !field.is_default &&
           (field.info->key == "stiffness" || field.info->key == "springdamper");
  };
  return detent.is_default && (entry.FindChild(spec::kScrewElement) != nullptr ||
                               std::ranges::any_of(entry.fields, is_spring));
}

}  // namespace

bool ReadDetent(FieldReader& reader, const spec::Entry& entry, model::Joint& joint) {
  const spec::Field* field = entry.Find(Key::kDetent);
  if (field == nullptr || HasOwnSpring(entry, *field)) return true;
  if (joint.type != "hinge" && joint.type != "slide")
    return reader.Report(Code::kModelBadValue, *field,
                         fmt::format("has no meaning for a {} joint", joint.type));
  const std::optional<double> holding = reader.Number(*field);
  if (!holding) return false;
  if (!joint.range)
    return reader.Report(Code::kModelBadValue, *field, "needs a range that is in force");
  const auto add = [&](std::string_view name, sample::Numbers numbers) {
    AddUnlessPresent({.name = name, .numbers = std::move(numbers)}, joint.attributes);
  };
  const double lower = joint.range->x(), upper = joint.range->y();
  add("springref", {(lower + upper) / 2});
  const double centre = model::FindAttribute(joint.attributes, "springref")->numbers.front();
  if (!(lower < centre && centre < upper))
    return reader.Report(
        Code::kModelBadValue, *field,
        fmt::format("needs its dead centre, springref, between {} and {}; it is {}",
                    expr::NumberText(lower), expr::NumberText(upper), expr::NumberText(centre)));
  // At the end of the range that is farther from the dead centre, the spring holds the joint with
  // the force (N) or torque (Nm) `holding`. At the other end, the spring holds with less.
  const double stiffness = *holding / std::max(upper - centre, centre - lower);
  std::erase_if(joint.attributes, [](const model::Attribute& attribute) {
    return attribute.name == "stiffness" || attribute.name == "springdamper";
  });
  add("stiffness", {-stiffness});
  add("damping", {stiffness * kSnapTime});
  add("armature", {stiffness * kPeriod * kPeriod});
  add("solreflimit", kEndReference);
  add("solimplimit", kEndImpedance);
  return true;
}

}  // namespace mjforge::assemble
