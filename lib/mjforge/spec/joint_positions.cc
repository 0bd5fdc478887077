// Reader of joint positions: `pose:`, and `at:` of expectations and checks.

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

using diag::Code;

namespace {

// Returns true if only a ball joint can have a position of this form.
bool IsTurn(const YamlNode& position) {
  return position.kind == YamlNode::Kind::kList || position.Find("about") != nullptr ||
         position.text == "random";
}

}  // namespace

std::vector<JointPosition> ReadPositions(const YamlNode& positions, Context& context) {
  static constexpr FieldInfo kOne = {
      .key = "a position", .kind = FieldKind::kNumbers, .max_count = 4, .unit = "rad or m"};
  static constexpr FieldInfo kTurn = {
      .key = "quat", .kind = FieldKind::kNumbers, .min_count = 4, .max_count = 4};
  std::vector<JointPosition> all;
  if (!IsMap(positions, "names and positions of joints", context)) return all;
  for (const YamlNode::Pair& pair : positions.pairs) {
    const FieldInfo& field = IsTurn(pair.value) ? kTurn : kOne;
    JointPosition position = {context.values.ReadText(YamlNode::Scalar(pair.key, pair.mark)),
                              pair.mark, context.values.Read(field, pair.value)};
    const Value& value = position.value;
    if (value.components == 0) continue;  // already reported
    if (value.components == 2 || value.components == 3) {
      context.findings.Add(Code::kSpecWrongType, value.mark,
                           fmt::format("the position of joint '{}' is {}, not a number or the four "
                                       "of a quaternion",
                                       pair.key, KindText(value)));
      continue;
    }
    all.push_back(std::move(position));
  }
  return all;
}

}  // namespace mjforge::spec
