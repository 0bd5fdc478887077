// Positions of joints in `pose:` and `at:`: conversion to qpos, with checks.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using expr::Dimension;

// Tolerance at the ends of a range, because the conversion of a position from degrees to radians
// rounds. Relative to the length of the range; for ball joints, an angle in rad.
constexpr double kTolerance = 1e-9;

bool IsWithin(const Eigen::Vector2d& range, double position) {
  const double slack = kTolerance * (range[1] - range[0]);
  return position >= range[0] - slack && position <= range[1] + slack;
}

// Returns true if the angle of the rotation q (w, x, y, z) is at most range[1], rad.
bool IsTurnedWithin(const Eigen::Vector2d& range, const Eigen::Vector4d& q) {
  return 2 * std::acos(std::min(std::abs(q[0]), 1.0)) <= range[1] + kTolerance;
}

// Returns a dimension other than `unit` of the value's numbers, or of an option of a choice;
// nullopt if there is none.
std::optional<Dimension> OtherDimension(const spec::Value& value, const Dimension& unit) {
  for (const Dimension& given : value.dimensions) {
    if (!given.is_plain() && given != unit) return given;
  }
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  if (draw == nullptr || (draw->distribution != spec::Distribution::kChoice &&
                          draw->distribution != spec::Distribution::kCycle))
    return std::nullopt;
  for (const spec::Value& option : draw->arguments) {
    if (const auto other = OtherDimension(option, unit)) return other;
  }
  return std::nullopt;
}

// Describes how the unit of a position differs from that of the joint; returns an empty text if
// they agree. The numbers of a ball joint were checked when the spec was read.
std::string UnitClash(const RequestedPosition& position, const model::Joint& joint) {
  if (position.value == nullptr || joint.type == "ball") return {};
  const Dimension unit = PositionDimension(joint);
  const auto other = OtherDimension(*position.value, unit);
  return other ? fmt::format("is in {}, but this is in {}", unit.Text(), other->Text()) : "";
}

std::string FreeHint(std::string_view what) {
  return what == "pose"
             ? "in a list: `{joint: NAME, pos: [0, 0, 1m]}`"
             : "where a free body is follows from its `pos`, which a parameter may decide";
}

}  // namespace

Dimension PositionDimension(const model::Joint& joint) {
  return joint.type == "slide" ? Dimension(1, 0, 0) : Dimension::Angle();
}

void Assembly::ReportUnknownJoint(std::string_view what, const RequestedPosition& position) {
  const std::size_t prefix = position.joint.size() - position.shown.size();
  std::vector<std::string_view> names;
  for (const model::Body& body : object_.bodies) {
    for (const model::Joint& joint : body.joints) {
      const std::string_view name = joint.name;
      if (name.starts_with(position.joint.substr(0, prefix))) names.push_back(name.substr(prefix));
    }
  }
  findings_.Add(Code::kModelUnknownReference, position.mark,
                fmt::format("{}: the object has no joint {}", what, Quoted(position.shown)),
                MissingNameHint(object_, position.joint, position.shown, names));
}

std::optional<sample::Numbers> Assembly::ToQpos(std::string_view what,
                                                const RequestedPosition& position,
                                                const model::Joint& joint) {
  sample::Numbers numbers = position.numbers;
  const auto bad = [&](const std::string& wrong, std::string hint = {}) {
    findings_.Add(Code::kModelBadValue, position.mark,
                  fmt::format("{} of joint {} {}", what, Quoted(position.shown), wrong),
                  std::move(hint));
    return std::nullopt;
  };
  if (joint.type == "free") return bad("cannot be set: it is free", FreeHint(what));
  if (const std::string clash = UnitClash(position, joint); !clash.empty()) return bad(clash);
  const std::size_t wanted = joint.type == "ball" ? 4 : 1;
  if (numbers.size() != wanted) {
    return bad(fmt::format("has {} numbers, but a {} takes {}", numbers.size(), joint.type, wanted),
               wanted == 4 ? "a quaternion: w, x, y, z" : "");
  }
  if (wanted == 4) {
    const Eigen::Vector4d q(numbers.data());
    if (!(q.norm() > kTolerance)) return bad("is not a rotation: all numbers are 0");
    const Eigen::Vector4d unit = q.normalized();
    numbers.assign(unit.begin(), unit.end());
    if (joint.range && !IsTurnedWithin(*joint.range, unit)) {
      return bad(fmt::format("is turned by more than its range, {} rad",
                             expr::NumberText((*joint.range)(1))));
    }
  } else if (joint.range && !IsWithin(*joint.range, numbers[0])) {
    const double number = numbers[0];
    // True if the number would be within the range in degrees, because the author may have meant
    // degrees.
    const bool is_degrees = joint.type == "hinge" && std::abs(number) > 2 * std::numbers::pi &&
                            IsWithin(*joint.range, number * std::numbers::pi / 180);
    return bad(
        fmt::format("is {}, outside its range {} .. {}", expr::NumberText(number),
                    expr::NumberText((*joint.range)(0)), expr::NumberText((*joint.range)(1))),
        is_degrees ? fmt::format("angles are in rad: write {}deg", expr::NumberText(number)) : "");
  }
  return numbers;
}

}  // namespace mjforge::assemble
