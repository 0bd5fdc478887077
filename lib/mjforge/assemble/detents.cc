// Detents: joints that snap to either end of their range.

#include "mjforge/assemble/detents.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// The joint crosses its range in about this time, s: damping over stiffness. A faster one would
// strike the limit at a speed that MuJoCo's usual timestep of 2 ms does not resolve.
constexpr double kSnapTime = 0.03;
// The period, s, by which the armature of a light joint is chosen: the square root of inertia over
// stiffness. MuJoCo makes limits as soft as the inertia of the joint demands, so that without
// armature the spring would push a light lever through its limit.
constexpr double kPeriod = 0.02;
// Limits that hardly give way under the spring: as stiff as the usual timestep allows, and with the
// impedance of couplings.
constexpr double kEndReference[] = {0.004, 1};
constexpr double kEndImpedance[] = {0.99, 0.999, 0.001, 0.5, 2};

void SetUnlessGiven(std::string_view name, sample::Numbers numbers, model::Joint& joint) {
  if (model::FindAttribute(joint.attributes, name) != nullptr) return;
  joint.attributes.push_back({.name = name, .numbers = std::move(numbers), .text = {}});
}

}  // namespace

bool ReadDetent(FieldReader& reader, const spec::Entry& entry, model::Joint& joint) {
  const spec::Field* field = entry.Find(Key::kDetent);
  if (field == nullptr) return true;
  const std::optional<double> holding = reader.Number(*field);
  if (!holding) return false;
  if (!joint.range) {
    reader.Report(Code::kModelBadValue, *field, "needs a range that is in force");
    return false;
  }
  const double lower = (*joint.range)[0];
  const double upper = (*joint.range)[1];
  SetUnlessGiven("springref", {(lower + upper) / 2}, joint);
  const double centre = model::FindAttribute(joint.attributes, "springref")->numbers.front();
  if (!(lower < centre && centre < upper)) {
    reader.Report(
        Code::kModelBadValue, *field,
        fmt::format("needs its dead centre, springref, between {} and {}; it is {}",
                    expr::NumberText(lower), expr::NumberText(upper), expr::NumberText(centre)));
    return false;
  }
  // At the nearer end the joint is held by less.
  const double stiffness = *holding / std::max(upper - centre, centre - lower);
  std::erase_if(joint.attributes,
                [](const model::Attribute& attribute) { return attribute.name == "stiffness"; });
  SetUnlessGiven("stiffness", {-stiffness}, joint);
  SetUnlessGiven("damping", {stiffness * kSnapTime}, joint);
  SetUnlessGiven("armature", {stiffness * kPeriod * kPeriod}, joint);
  SetUnlessGiven("solreflimit", {std::begin(kEndReference), std::end(kEndReference)}, joint);
  SetUnlessGiven("solimplimit", {std::begin(kEndImpedance), std::end(kEndImpedance)}, joint);
  return true;
}

}  // namespace mjforge::assemble
