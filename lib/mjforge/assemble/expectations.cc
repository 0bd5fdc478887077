// Reader of `expect:`: evaluates conditions, and adds the expected distances and contacts to the
// object.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"

namespace mjforge::assemble {

using diag::Code;
using spec::Key;

void Assembly::AddExpectations(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (spec.expectations.empty() || findings_.HasErrors()) return;
  if (spec.mass_slot >= 0) scope.values.SetVariable(spec.mass_slot, object_.mass_properties.mass);
  if (spec.bounds_slot >= 0) {
    const Eigen::Vector3d size = object_.bounds.aabb.max - object_.bounds.aabb.min;
    for (int i = 0; i < 3; ++i) scope.values.SetVariable(spec.bounds_slot + i, size[i]);
  }
  for (const spec::Expectation& entry : spec.expectations) {
    // Only the first unmet instance of a condition is reported.
    const std::size_t unmet = object_.unmet_expectations.size();
    repetition_.ForEach(entry.entry, scope.values, sample::Child(scope.values.root(), "expect"),
                        [&] {
                          if (!entry.condition) {
                            AddExpectation(scope, entry);
                          } else if (object_.unmet_expectations.size() == unmet) {
                            CheckCondition(scope, entry);
                          }
                        });
  }
}

void Assembly::CheckCondition(Scope& scope, const spec::Expectation& entry) {
  const expr::Expression& condition = *entry.condition;
  if (scope.values.Condition(condition, entry.entry.mark).value_or(true)) return;
  const std::string numbers = scope.values.InputsText(condition);
  diag::Finding& finding = object_.unmet_expectations.emplace_back();
  finding.code = Code::kModelExpectation;
  finding.mark = entry.entry.mark;
  finding.message =
      fmt::format("'{}' does not hold{}{}", condition.text(), numbers.empty() ? "" : ": ", numbers);
  finding.hint = entry.doc;
  if (finding.hint.empty() && condition.text().find("==") != std::string::npos)
    finding.hint = "computed numbers may differ by a rounding: compare abs(a - b) with a tolerance";
}

void Assembly::AddExpectation(Scope& scope, const spec::Expectation& entry) {
  model::Expectation expectation;
  expectation.kind = entry.kind;
  expectation.doc = entry.doc;
  expectation.mark = entry.entry.mark;
  const auto first = FullName(scope, entry.names[0]);
  const auto second = FullName(scope, entry.names[1]);
  if (!first || !second) return;
  expectation.first = *first;
  expectation.second = *second;
  if (*first == *second) {
    findings_.Add(Code::kModelBadValue, entry.names[1].mark, "the two names are the same");
    return;
  }
  FieldReader reader(scope.values, findings_, "expectation", "gap", scope.values.root());
  if (const spec::Field* min = entry.entry.Find(Key::kMin)) expectation.min = reader.Number(*min);
  if (const spec::Field* max = entry.entry.Find(Key::kMax)) expectation.max = reader.Number(*max);
  for (const spec::JointPosition& at : entry.at) {
    RequestedPosition position;
    position.shown = scope.values.Text(at.joint, scope.values.root()).value_or("");
    position.joint = scope.prefix + position.shown;
    position.mark = at.mark;
    scope.values.Vector(at.value, scope.values.root(), position.numbers);
    position.value = &at.value;
    const model::Joint* joint = model::FindJoint(object_, position.joint);
    if (joint == nullptr) {
      ReportUnknownJoint("at", position);
      return;
    }
    auto qpos = ToQpos("position", position, *joint);
    if (!qpos) return;
    expectation.positions.emplace_back(position.joint, *std::move(qpos));
  }
  object_.expectations.push_back(std::move(expectation));
}

std::optional<std::string> Assembly::FullName(Scope& scope, const spec::Value& value) {
  const std::optional<std::string> name = scope.values.Text(value, scope.values.root());
  if (!name) return std::nullopt;
  const model::Body& root = object_.bodies.front();
  if (*name == scope.values.spec().name) return root.name;
  const std::string full = scope.prefix + *name;
  std::vector<std::string_view> known = {scope.values.spec().name};
  const auto matches = [&](std::string_view other) {
    if (other.starts_with(scope.prefix)) known.push_back(other.substr(scope.prefix.size()));
    return other == full;
  };
  for (const model::Body& body : object_.bodies) {
    if (matches(body.name)) return full;
    for (const model::Part& part : body.parts) {
      if (matches(part.name) || (!part.piece_of.empty() && matches(part.piece_of))) return full;
    }
  }
  findings_.Add(Code::kModelUnknownReference, value.mark,
                fmt::format("the object has no body and no part {}", Quoted(*name)),
                MissingNameHint(object_, full, *name, known));
  return std::nullopt;
}

}  // namespace mjforge::assemble
