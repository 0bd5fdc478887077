// checks: of the spec, evaluated for one variant.

#include <algorithm>

#include "mjforge/diag/diag.h"
#include "mjforge/model/assembly.h"

namespace mjforge::model {
namespace {

struct NumberCheck {
  std::string_view key;
  double Checks::*member;
};
constexpr NumberCheck kNumbers[] = {
    {"self_collision", &Checks::self_collision},
    {"settle_time", &Checks::settle_time},
    {"rest_speed", &Checks::rest_speed},
    {"tilt", &Checks::tilt},
    {"drift", &Checks::drift},
    {"penetration", &Checks::penetration},
    {"sink", &Checks::sink},
    {"energy_gain", &Checks::energy_gain},
    {"joint_overshoot", &Checks::joint_overshoot},
    {"joint_reach", &Checks::joint_reach},
    {"joint_penetration", &Checks::joint_penetration},
    {"joint_return", &Checks::joint_return},
    {"overlap", &Checks::overlap},
    {"thickness", &Checks::thickness},
    {"aspect", &Checks::aspect},
    {"gap", &Checks::gap},
};

struct RangeCheck {
  std::string_view key;
  Eigen::Vector2d Checks::*member;
};
constexpr RangeCheck kRanges[] = {
    {"density", &Checks::density},
    {"bulk_density", &Checks::bulk_density},
};

void ReadCheck(const spec::Field& field, FieldReader& reader, Checks& checks) {
  if (field.info->key == "stable") {
    checks.stable = reader.Boolean(field).value_or(checks.stable);
  }
  for (const NumberCheck& check : kNumbers) {
    if (check.key == field.info->key)
      checks.*check.member = tape::Fixed(reader.Number(field).value_or(checks.*check.member));
  }
  for (const RangeCheck& check : kRanges) {
    if (check.key != field.info->key) continue;
    const auto range = reader.Vector<2>(field);
    if (range && range->x() > range->y()) {
      reader.Report(diag::Code::kModelBadValue, field, "has its higher end first");
    }
    checks.*check.member = tape::Fixed(range.value_or(checks.*check.member));
  }
}

void ReadHolding(const spec::Field& field, FieldReader& reader, Holding& holds) {
  const std::string_view key = field.info->key;
  if (key == "ball") {
    sample::Numbers sizes;
    if (!reader.Numbers(field, sizes)) return;
    holds.ball = {tape::Fixed(sizes.front()), tape::Fixed(sizes.back())};
    if (holds.ball.x() > holds.ball.y())
      reader.Report(diag::Code::kModelBadValue, field, "has its larger ball first");
  } else if (key == "at") {
    if (const auto at = reader.Vector<2>(field)) holds.at = tape::Fixed(*at);
  } else if (key == "without") {
    holds.without = reader.Text(field).value_or("");
  } else if (key == "empties") {
    holds.empties = reader.Boolean(field).value_or(holds.empties);
  } else if (const auto number = reader.Number(field)) {
    if (key == "drop") holds.drop = tape::Fixed(*number);
    if (key == "balls") holds.balls = static_cast<int>(tape::Fixed(*number));
  }
}

}  // namespace

void Assembly::ReadChecks(Scope& scope) {
  const spec::Checks& checks = scope.values.spec().checks;
  FieldReader reader(scope.values, findings_, "checks", object_.name, scope.values.root());
  for (const spec::Field& field : checks.fields) ReadCheck(field, reader, object_.checks);
  if (checks.holds) {
    FieldReader in_holds(scope.values, findings_, "holds", object_.name, scope.values.root());
    Holding& holds = object_.checks.holds.emplace();
    holds.mark = checks.holds->mark;
    for (const spec::Field& field : checks.holds->fields) ReadHolding(field, in_holds, holds);
  }
  for (const auto& [code, reason] : checks.silenced) {
    object_.checks.silenced.emplace_back(diag::CodeName(code), reason);
  }
}

}  // namespace mjforge::model
