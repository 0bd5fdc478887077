// Reads `checks:` of a spec, with the values of one variant, into Object::checks.

#include <functional>
#include <utility>

#include "mjforge/assemble/assembly.h"
#include "mjforge/diag/diag.h"

namespace mjforge::assemble {
namespace {

template <typename Struct, typename Member>
using KeyedMember = std::pair<std::string_view, Member Struct::*>;

constexpr KeyedMember<model::Checks, bool> kBooleans[] = {
    {"stable", &model::Checks::stable},
    {"drive", &model::Checks::drive},
};

constexpr KeyedMember<model::Checks, double> kNumbers[] = {
    {"self_collision", &model::Checks::self_collision},
    {"settle_time", &model::Checks::settle_time},
    {"rest_speed", &model::Checks::rest_speed},
    {"tilt", &model::Checks::tilt},
    {"nudge", &model::Checks::nudge},
    {"drift", &model::Checks::drift},
    {"penetration", &model::Checks::penetration},
    {"sink", &model::Checks::sink},
    {"energy_gain", &model::Checks::energy_gain},
    {"joint_overshoot", &model::Checks::joint_overshoot},
    {"joint_reach", &model::Checks::joint_reach},
    {"joint_penetration", &model::Checks::joint_penetration},
    {"joint_return", &model::Checks::joint_return},
    {"equality_error", &model::Checks::equality_error},
    {"hinge_range", &model::Checks::hinge_range},
    {"slide_range", &model::Checks::slide_range},
    {"overlap", &model::Checks::overlap},
    {"thickness", &model::Checks::thickness},
    {"aspect", &model::Checks::aspect},
    {"gap", &model::Checks::gap},
    {"look", &model::Checks::look},
};

constexpr KeyedMember<model::Checks, Eigen::Vector2d> kRanges[] = {
    {"density", &model::Checks::density},
    {"bulk_density", &model::Checks::bulk_density},
};

constexpr KeyedMember<model::FittingCheck, std::string> kFittingTexts[] = {
    {"hole", &model::FittingCheck::hole},
    {"body", &model::FittingCheck::body},
    {"tip", &model::FittingCheck::tip}};

constexpr KeyedMember<model::GraspingCheck, double> kGraspingNumbers[] = {
    {"width", &model::GraspingCheck::width},
    {"force", &model::GraspingCheck::force},
    {"pull", &model::GraspingCheck::pull}};

constexpr KeyedMember<model::SettlingCheck, double> kSettlingNumbers[] = {
    {"time", &model::SettlingCheck::time},
    {"moved", &model::SettlingCheck::moved},
    {"turned", &model::SettlingCheck::turned},
};

constexpr KeyedMember<model::JointCheck, std::optional<double>> kJointNumbers[] = {
    {"overshoot", &model::JointCheck::overshoot},
    {"reach", &model::JointCheck::reach},
    {"penetration", &model::JointCheck::penetration},
    {"return", &model::JointCheck::joint_return},
};

constexpr KeyedMember<model::PartCheck, std::optional<double>> kPartNumbers[] = {
    {"thickness", &model::PartCheck::thickness}, {"aspect", &model::PartCheck::aspect}};

// Reads a field, and assigns the value to the member of `out` that `table` lists for the field's
// key.
template <typename Table, typename Read, typename Struct>
void SetMember(const Table& table, Read read, FieldReader& reader, const spec::Field& field,
               Struct& out) {
  for (const auto& [key, member] : table) {
    if (key != field.info->key) continue;
    if (const auto value = std::invoke(read, reader, field)) out.*member = *value;
  }
}

std::optional<Eigen::Vector2d> ReadLimits(FieldReader& reader, const spec::Field& field) {
  auto range = reader.Vector<2>(field);
  if (range && range->x() > range->y())
    reader.Report(diag::Code::kModelBadValue, field, "has its higher end first");
  return range;
}

void ReadHolding(const spec::Field& field, FieldReader& reader, model::HoldingCheck& holds) {
  const std::string_view key = field.info->key;
  if (key == "ball") {
    sample::Numbers sizes;
    if (!reader.Numbers(field, sizes)) return;
    holds.ball = {sizes.front(), sizes.back()};
    if (holds.ball.x() > holds.ball.y())
      reader.Report(diag::Code::kModelBadValue, field, "has the larger diameter first");
  } else if (key == "at") {
    if (const auto at = reader.Vector<2>(field)) holds.at = *at;
  } else if (key == "without") {
    holds.without = reader.Text(field).value_or("");
  } else if (key == "empties") {
    holds.empties = reader.Boolean(field).value_or(holds.empties);
  } else if (const auto number = reader.Number(field)) {
    if (key == "drop") holds.drop = *number;
    if (key == "balls") holds.balls = static_cast<int>(*number);
  }
}

}  // namespace

void Assembly::ReadJointCheck(Scope& scope, const spec::Checks::JointCheck& entry) {
  const sample::StreamId root = scope.values.root();
  model::JointCheck& check = object_.checks.joints.emplace_back();
  check.mark = entry.entry.mark;
  check.skip = entry.skip;
  for (const spec::Value& joint : entry.joints)
    check.joints.emplace_back(scope.values.Text(joint, root).value_or(""));
  FieldReader reader(scope.values, findings_, "joint check", check.joints.front(), root);
  for (const spec::Field& field : entry.entry.fields) {
    SetMember(kJointNumbers, &FieldReader::Number, reader, field, check);
    if (field.info->key == "rests") check.rests = ReadLimits(reader, field);
  }
  for (const spec::JointPosition& at : entry.at) {
    sample::Numbers numbers;
    scope.values.Vector(at.value, root, numbers);
    auto& [joint, position] = check.positions.emplace_back();
    joint = scope.values.Text(at.joint, root).value_or("");
    for (const auto& number : numbers) position.push_back(number);
  }
}

void Assembly::ReadPartCheck(Scope& scope, const spec::Checks::PartCheck& entry) {
  const sample::StreamId root = scope.values.root();
  model::PartCheck& check = object_.checks.parts.emplace_back();
  check.mark = entry.entry.mark;
  for (const spec::Value& part : entry.parts)
    check.parts.emplace_back(scope.values.Text(part, root).value_or(""));
  if (check.parts.empty()) return;
  FieldReader reader(scope.values, findings_, "limit", check.parts.front(), root);
  for (const spec::Field& field : entry.entry.fields) {
    if (field.info->key == "density") check.density = ReadLimits(reader, field);
    SetMember(kPartNumbers, &FieldReader::Number, reader, field, check);
  }
}

void Assembly::ReadGrasps(Scope& scope, const spec::Checks::Grasping& entry) {
  const sample::StreamId root = scope.values.root();
  model::GraspingCheck& grasps = object_.checks.grasps.emplace();
  grasps.mark = entry.mark;
  for (const spec::Value& site : entry.sites)
    grasps.sites.emplace_back(scope.values.Text(site, root).value_or(""));
  FieldReader reader(scope.values, findings_, "grasps", object_.name, root);
  for (const spec::Field& field : entry.fields) {
    SetMember(kGraspingNumbers, &FieldReader::Number, reader, field, grasps);
    if (field.info->key == "tries")
      grasps.tries = static_cast<int>(reader.Number(field).value_or(grasps.tries));
  }
}

void Assembly::ReadFitting(Scope& scope, const spec::Checks::Fitting& entry) {
  const sample::StreamId root = scope.values.root();
  FieldReader reader(scope.values, findings_, "fits", object_.name, root);
  model::FittingCheck& fitting = object_.checks.fits.emplace_back();
  fitting.mark = entry.entry.mark;
  for (const spec::Field& field : entry.entry.fields) {
    SetMember(kFittingTexts, &FieldReader::Text, reader, field, fitting);
    if (field.info->key == "depth") fitting.depth = reader.Number(field).value_or(0);
    sample::Numbers sides;
    if (field.info->key != "peg" || !reader.Numbers(field, sides)) continue;
    fitting.is_round = sides.size() == 1;
    fitting.peg = {sides.front(), sides.back()};
  }
}

void Assembly::ReadChecks(Scope& scope) {
  const spec::Checks& checks = scope.values.spec().checks;
  FieldReader reader(scope.values, findings_, "checks", object_.name, scope.values.root());
  for (const spec::Field& field : checks.fields) {
    if (field.info->key == "profile") object_.checks.simready = reader.Word(field) == "simready";
    SetMember(kBooleans, &FieldReader::Boolean, reader, field, object_.checks);
    SetMember(kNumbers, &FieldReader::Number, reader, field, object_.checks);
    SetMember(kRanges, ReadLimits, reader, field, object_.checks);
  }
  if (checks.holds) {
    FieldReader in_holds(scope.values, findings_, "holds", object_.name, scope.values.root());
    model::HoldingCheck& holds = object_.checks.holds.emplace();
    holds.mark = checks.holds->mark;
    for (const spec::Field& field : checks.holds->fields) ReadHolding(field, in_holds, holds);
  }
  if (checks.settled) {
    FieldReader in_settled(scope.values, findings_, "settled", object_.name, scope.values.root());
    model::SettlingCheck& settled = object_.checks.settled.emplace();
    settled.mark = checks.settled->mark;
    for (const spec::Field& field : checks.settled->fields)
      SetMember(kSettlingNumbers, &FieldReader::Number, in_settled, field, settled);
  }
  if (checks.grasps) ReadGrasps(scope, *checks.grasps);
  const sample::StreamId list = sample::Child(scope.values.root(), "checks");
  for (const spec::Checks::JointCheck& entry : checks.joints)
    repetition_.ForEach(entry.entry, scope.values, list, [&] { ReadJointCheck(scope, entry); });
  for (const spec::Checks::PartCheck& entry : checks.parts)
    repetition_.ForEach(entry.entry, scope.values, list, [&] { ReadPartCheck(scope, entry); });
  for (const spec::Checks::Fitting& entry : checks.fits)
    repetition_.ForEach(entry.entry, scope.values, list, [&] { ReadFitting(scope, entry); });
  for (const auto& [code, reason] : checks.silenced) {
    object_.checks.silenced.emplace_back(diag::CodeName(code), reason);
  }
}

}  // namespace mjforge::assemble
