// Where joints stand: `pose:`, and `at:` of an expectation.

#include <fmt/format.h>

#include "mjforge/spec/reading.h"

namespace mjforge::spec {

using diag::Code;

namespace {

/// Whether only a ball joint has such a position.
bool IsTurn(const YamlNode& position) {
  switch (position.kind) {
    case YamlNode::Kind::kList:
      return true;
    case YamlNode::Kind::kMap:
      return position.Find("about") != nullptr;
    default:
      return position.text == "random";
  }
}

}  // namespace

std::vector<Position> ReadPositions(const YamlNode& positions, Reading& reading) {
  static constexpr FieldInfo kOne = {
      .key = "a position", .slot = Slot::kNumbers, .max_count = 4, .unit = "rad or m"};
  static constexpr FieldInfo kTurn = {
      .key = "quat", .slot = Slot::kNumbers, .min_count = 4, .max_count = 4};
  std::vector<Position> all;
  if (!IsMap(positions, "names and positions of joints", reading)) return all;
  for (const YamlNode::Pair& pair : positions.pairs) {
    const FieldInfo& field = IsTurn(pair.value) ? kTurn : kOne;
    YamlNode name;
    name.kind = YamlNode::Kind::kScalar;
    name.mark = pair.mark;
    name.text = pair.key;
    Position position = {reading.values.ReadText(name), pair.mark,
                         reading.values.Read(field, pair.value)};
    const Value& value = position.value;
    if (value.components == 0) continue;  // reported
    if (value.components == 2 || value.components == 3) {
      reading.findings.Add(Code::kSpecWrongType, value.mark,
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
