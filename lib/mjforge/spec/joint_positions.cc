// Reader of joint positions: the start state `pose:`, `at:` of expectations and checks, and `pose:`
// of the view.

#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;

constexpr FieldInfo kPosition = {
    .key = "a position", .kind = FieldKind::kPosition, .max_count = 4, .unit = "rad or m"};

// Returns true if only a ball joint can have a position of this form.
bool IsTurn(const YamlNode& position) {
  return position.kind == YamlNode::Kind::kList || position.Find("about") != nullptr ||
         position.text == "random";
}

Entry ReadStart(const YamlNode& map, Context& context) {
  EntryReader entries(context);
  const YamlNode::Pair* actuator = map.FindPair("actuator");
  if (actuator != nullptr && map.Find("joint") != nullptr) {
    context.findings.Add(Code::kSpecConflict, actuator->mark,
                         "'actuator' together with 'joint': an entry has only one of the two");
  }
  const std::string_view kind = actuator == nullptr ? "joint" : "actuator";
  Entry entry = entries.Begin(kStartElement, map, map, EntryReader::Naming::kRequired, kind);
  entry.fields = ReadElementFields(kStartElement, map, context);
  if (actuator != nullptr) {
    entries.RejectKeys(map, {"actuator", "joint", "for", "if", "let", "ctrl", "act"}, kStartElement,
                       "an actuator");
  } else {
    entries.RejectKeys(map,
                       {"joint", "for", "if", "let", "value", "pos", "quat", "euler", "axisangle",
                        "xyaxes", "zaxis", "velocity"},
                       kStartElement, "a joint");
  }
  if (entry.fields.empty()) {
    context.findings.Add(Code::kSpecMissingKey, map.mark,
                         actuator == nullptr ? "start of a joint without a 'value'"
                                             : "start of an actuator without 'ctrl' or 'act'");
  }
  entries.End(entry);
  return entry;
}

}  // namespace

Value ValueReader::ReadPosition(const FieldInfo& field, const YamlNode& node, Motion motion) {
  FieldInfo form = field;
  form.kind = FieldKind::kNumbers;
  const bool is_turn = IsTurn(node);
  if (is_turn) {
    form.key = "quat";
    form.min_count = 4;
    form.unit = {};
  }
  const bool is_list = node.kind == YamlNode::Kind::kList;
  const std::size_t count = node.items.size();
  if (is_list) {  // accepts every count, because a wrong count has a message of its own below
    form.min_count = 0;
    form.max_count = std::numeric_limits<int>::max();
  }
  Value value = Read(form, node, motion);
  // Skips lists that Read() already reported.
  if (is_list && count != 4 && (count == 0 || value.components != 0)) {
    findings_.Add(Code::kSpecWrongLength, value.mark,
                  fmt::format("expected a number, or the four numbers of a ball joint's "
                              "quaternion, got a list of {}",
                              count));
    value.components = 0;
    return value;
  }
  if (value.components != 2 && value.components != 3) return value;
  if (!is_turn) {  // Read() already reported a wrong quaternion
    findings_.Add(
        Code::kSpecWrongType, value.mark,
        fmt::format("a position is a number or the four of a quaternion, not {}", KindText(value)));
  }
  value.components = 0;
  return value;
}

std::vector<JointPosition> ReadPositions(const YamlNode& positions, Context& context) {
  std::vector<JointPosition> all;
  if (!IsMap(positions, "names and positions of joints", context)) return all;
  for (const YamlNode::Pair& pair : positions.pairs) {
    JointPosition position = {context.values.ReadText(YamlNode::Scalar(pair.key, pair.mark)),
                              pair.mark, context.values.Read(kPosition, pair.value)};
    if (position.value.components != 0) all.push_back(std::move(position));  // 0: already reported
  }
  return all;
}

std::vector<Entry> ReadStarts(const YamlNode& pose, Context& context) {
  std::vector<Entry> starts;
  if (pose.kind != YamlNode::Kind::kList) {
    for (JointPosition& position : ReadPositions(pose, context)) {
      Entry& start = starts.emplace_back();
      start.element = &kStartElement;
      start.mark = position.mark;
      start.name = std::move(position.joint);
      start.fields.emplace_back(kStartElement.Find(Key::kValue), std::move(position.value),
                                position.mark);
    }
    return starts;
  }
  for (const YamlNode& item : pose.items) {
    if (IsMap(item, "a start's keys", context)) starts.push_back(ReadStart(item, context));
  }
  return starts;
}

}  // namespace mjforge::spec
