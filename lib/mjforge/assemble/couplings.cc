// Reader of `couple:` and `screw:`, which builds equalities between joints.

#include "mjforge/assemble/couplings.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/pose_reader.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Impedance (solimp) of linear couplings, in place of MuJoCo's default "0.9 0.95 ...", because
// gears and threads hardly yield.
constexpr std::initializer_list<double> kImpedance = {0.99, 0.999, 0.001, 0.5, 2};
// Impedance of nonlinear couplings: the largest values that MuJoCo uses (mjMAXIMP). EqualityOf()
// cannot swap the joints of a nonlinear coupling, and MuJoCo makes the equality far too soft if
// joint 2 is light.
constexpr std::initializer_list<double> kImpedanceOfCurve = {0.9999, 0.9999, 0.001, 0.5, 2};

// Returns the equality that keeps `follower` at c[0] + c[1] x + ... when `leader` is at x. If the
// polynomial is linear, the joint that moves farther becomes joint 1. The reason is that MuJoCo
// scales the softness by the sum of the joints' inverse inertias, without the polynomial's slope
// (mj_diagApprox in src/engine/engine_core_constraint.c). If joint 2 is light and the slope is
// below 1, the sum is too large, and the equality too soft.
model::Element EqualityOf(std::string follower, std::string leader, sample::Numbers c) {
  const bool is_linear = std::all_of(c.begin() + 2, c.end(), [](double x) { return x == 0; });
  const bool is_small = std::abs(c[1]) < 1 && std::isfinite(1 / c[1]) && std::isfinite(c[0] / c[1]);
  if (is_linear && is_small) {
    std::swap(follower, leader);
    c[0] = c[0] == 0 ? 0 : -c[0] / c[1];
    c[1] = 1 / c[1];
  }
  model::Element equality;
  equality.tag = "joint";
  equality.attributes = {{.name = "joint1", .text = std::move(follower), .refers = "joint"},
                         {.name = "joint2", .text = std::move(leader), .refers = "joint"},
                         {.name = "polycoef", .numbers = std::move(c)},
                         {.name = "solimp", .numbers = is_linear ? kImpedance : kImpedanceOfCurve}};
  return equality;
}

// Reads `turns:`, the range of a screw's hinge in full turns; a single number N means 0 to N.
// Leaves `range` unchanged if the entry has no `turns:`. Returns false after adding a finding.
bool ReadTurns(FieldReader& reader, const spec::Entry& screw,
               std::optional<Eigen::Vector2d>& range) {
  const spec::Field* field = screw.Find(Key::kTurns);
  if (field == nullptr) return true;
  sample::Numbers turns;
  if (!reader.Numbers(*field, turns)) return false;
  if (turns.size() == 1) turns.insert(turns.begin(), 0.0);
  range = Eigen::Vector2d(turns[0], turns[1]);
  if (turns[0] < turns[1]) return true;
  return reader.Report(Code::kModelBadValue, *field,
                       fmt::format("is {} .. {}; it must go from a smaller to a larger number",
                                   expr::NumberText(turns[0]), expr::NumberText(turns[1])));
}

// Returns the travel of a screw per full turn, m; nullopt after adding a finding.
std::optional<double> ReadLead(FieldReader& reader, const spec::Field& field) {
  const std::optional<double> lead = reader.Number(field);
  if (!lead || std::isfinite(2 * std::numbers::pi / *lead)) return lead;
  reader.Report(Code::kModelBadValue, field,
                fmt::format("is {}; it must be farther from 0", expr::NumberText(*lead)));
  return std::nullopt;
}

// Returns the five coefficients that `polycoef`, `lead` or `ratio` of `couple:` specifies; nullopt
// after adding a finding.
std::optional<sample::Numbers> ReadPolynomial(FieldReader& reader, const spec::Entry& couple) {
  sample::Numbers c = {0, 0};
  if (const spec::Field* field = couple.Find(Key::kPolycoef)) {
    c.clear();
    if (!reader.Numbers(*field, c)) return std::nullopt;
  } else if (const spec::Field* lead = couple.Find(Key::kLead)) {
    const std::optional<double> m = ReadLead(reader, *lead);
    if (!m) return std::nullopt;
    c[1] = *m / (2 * std::numbers::pi);
  } else {
    const std::optional<double> ratio = reader.Number(*couple.Find(Key::kRatio));
    if (!ratio) return std::nullopt;
    c[1] = *ratio;
  }
  c.resize(5, 0.0);
  return c;
}

}  // namespace

void Couplings::AddScrew(const Scope& scope, const FieldReader& reader, const spec::Entry& screw,
                         model::Joint turn, model::Body& body) {
  FieldReader own = reader.ForChild(screw.element->name, 0);
  bool good = own.ReadOptional(screw, Key::kAxis, ReadDirection, turn.axis);
  const std::optional<double> lead = ReadLead(own, *screw.Find(Key::kLead));
  std::optional<Eigen::Vector2d> turns;
  good &= ReadTurns(own, screw, turns);
  if (!lead || !good) return;
  const std::string name = turn.name;
  model::Joint rise;
  rise.name = name + std::string(kRiseEnding);
  rise.type = "slide";
  rise.pos = turn.pos;
  rise.axis = turn.axis;
  rise.mark = turn.mark;
  turn.name = name + std::string(kTurnEnding);
  turn.type = "hinge";
  if (turns) {
    const Eigen::Vector2d ends = *turns * *lead;
    rise.range = Eigen::Vector2d(ends.minCoeff(), ends.maxCoeff());
    turn.range = *turns * 2 * std::numbers::pi;
  }
  Add(scope, own, screw, name,
      EqualityOf(turn.name, rise.name, {0, 2 * std::numbers::pi / *lead, 0, 0, 0}));
  body.joints.push_back(std::move(rise));
  body.joints.push_back(std::move(turn));
}

void Couplings::AddCouple(const Scope& scope, const FieldReader& reader, const spec::Entry& couple,
                          const model::Joint& follower) {
  FieldReader own = reader.ForChild(couple.element->name, 0);
  const std::optional<std::string> leader = own.Text(*couple.Find(Key::kJoint));
  std::optional<sample::Numbers> c = ReadPolynomial(own, couple);
  if (!leader || !c) return;
  const std::string full = scope.prefix + *leader;
  const spec::Field* lead = couple.Find(Key::kLead);
  if (full == follower.name) {
    own.Report(Code::kModelBadValue, *couple.Find(Key::kJoint), "is the joint itself");
  } else if (lead != nullptr && follower.type != "slide") {
    own.Report(Code::kModelBadValue, *lead, fmt::format("has no meaning for a {}", follower.type),
               "write a `ratio`");
  } else {
    leaders_.push_back({full, *leader, lead != nullptr, couple.Find(Key::kJoint)->value.mark});
    Add(scope, own, couple, follower.name, EqualityOf(follower.name, full, *std::move(c)));
  }
}

void Couplings::CheckLeaders(const model::Object& object, diag::Findings& findings) const {
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      for (const Leader& leader : leaders_) {
        if (leader.name != joint.name) continue;
        const bool turns = joint.type == "hinge";
        if (turns || (joint.type == "slide" && !leader.turns)) continue;
        findings.Add(Code::kModelBadValue, leader.mark,
                     fmt::format("joint '{}' is a {}; {}", leader.shown, joint.type,
                                 leader.turns ? "a joint with a `lead` follows a hinge"
                                              : "a joint follows a hinge or a slide"));
      }
    }
  }
}

void Couplings::Add(const Scope& scope, FieldReader& reader, const spec::Entry& entry,
                    const std::string& name, model::Element equality) {
  equality.name = name;
  equality.mark = entry.mark;
  bool good = true;
  for (const spec::Field& field : entry.fields) {
    if (field.info->id != Key::kAttribute) continue;
    model::Attribute attribute;
    good &= reader.ReadAttribute(field, attribute);
    std::erase_if(equality.attributes,
                  [&](const model::Attribute& other) { return other.name == attribute.name; });
    equality.attributes.push_back(std::move(attribute));
  }
  if (!good) return;
  const spec::SectionInfo& section = *spec::FindSection("equality");
  std::vector<model::Element>& elements = sections_.ElementsOf(section);
  const spec::Field* leader = entry.Find(Key::kJoint);
  for (const std::string_view key : {"joint1", "joint2"}) {
    const std::string& joint = model::FindAttribute(equality.attributes, key)->text;
    references_.Add({&section, elements.size()}, "joint", joint, joint.substr(scope.prefix.size()),
                    fmt::format("{} of {}", entry.element->name, reader.Owner()),
                    leader != nullptr ? leader->value.mark : entry.mark);
  }
  elements.push_back(std::move(equality));
}

}  // namespace mjforge::assemble
