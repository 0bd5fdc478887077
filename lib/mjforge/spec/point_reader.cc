// Functions of ValueReader that read lists of points, and `for:`, which repeats points and entries.

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {

using diag::Code;

namespace {

constexpr double kArcSteps = 8;

}  // namespace

template <typename Reader>
Value ValueReader::ReadPointLoop(const YamlNode& map, std::string_view key, Reader&& read) {
  const std::string what = fmt::format("repeated {}", key == "at" ? "points" : "outlines");
  AllowKeys(map, {"for", key}, what);
  const YamlNode* repeated = map.Find(key);
  if (repeated == nullptr) {
    findings_.Add(Code::kSpecMissingKey, map.mark, fmt::format("{} without '{}'", what, key),
                  key == "at" ? "as in {for: {i: 8}, at: [r(i), z(i)]}"
                              : "as in {for: {i: 3}, points: [[i, 0], [i + 0.5, 0], [i, 0.5]]}");
    return SubstituteFor(map);
  }
  PointLoop points;
  std::vector<Loop> loops = ReadLoops(*map.Find("for"));
  points.at = std::make_shared<const Value>(read(*repeated));
  EndLoops(loops);
  points.loops = std::make_shared<const std::vector<Loop>>(std::move(loops));
  Value value{.mark = map.mark, .components = points.at->components};
  value.dimensions = points.at->dimensions;
  value.form = std::move(points);
  return value;
}

Value ValueReader::ReadOutlines(const FieldInfo& expected, const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kList) return Wrong(node, "a list of outlines");
  Value value{.mark = node.mark, .components = static_cast<int>(node.items.size())};
  const auto read = [&](const YamlNode& points) { return ReadPoints(expected, points); };
  List outlines;
  for (const YamlNode& item : node.items) {
    const bool is_loop = item.Find("for") != nullptr;
    const bool has_axis = item.Find("axis") != nullptr || item.Find("outlines") != nullptr;
    outlines.items.push_back(is_loop    ? ReadPointLoop(item, "points", read)
                             : has_axis ? ReadAxisOutlines(expected, item)
                                        : read(item));
  }
  value.form = std::move(outlines);
  return value;
}

Value ValueReader::ReadAxisOutlines(const FieldInfo& expected, const YamlNode& map) {
  AllowKeys(map, {"axis", "outlines"}, "holes along an axis");
  for (const std::string_view key : {"axis", "outlines"}) {
    if (map.Find(key) != nullptr) continue;
    findings_.Add(Code::kSpecMissingKey, map.mark,
                  fmt::format("holes along an axis without '{}'", key),
                  "as in {axis: x, outlines: [[[-1cm, -1cm], [1cm, -1cm], [0, 1cm]]]}");
    return SubstituteFor(map);
  }
  const Value axis = ReadAxis(
      map, "holes", "outlines along x have points [y, z], along y [x, z], and along z [x, y]");
  const YamlNode& outlines = *map.Find("outlines");
  for (const YamlNode& item : outlines.items) {
    const YamlNode* nested = item.Find("axis");
    if (nested == nullptr) continue;
    findings_.Add(Code::kSpecBadValue, nested->mark, "holes along an axis within others",
                  "give each axis its own entry of `holes`");
    return SubstituteFor(map);
  }
  AxisOutlines along{.axis = static_cast<std::size_t>(std::get<double>(axis.form)),
                     .outlines = std::make_shared<const Value>(ReadOutlines(expected, outlines))};
  Value value{.mark = map.mark, .components = along.outlines->components};
  value.form = std::move(along);
  return value;
}

Value ValueReader::ReadPoints(const FieldInfo& expected, const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kList)
    return Wrong(
        node, expected.min_count == 2 ? "a list of points [x, y]" : "a list of points [x, y, z]");
  Value value{.mark = node.mark, .components = static_cast<int>(node.items.size())};
  const auto read = [&](const YamlNode& point) { return ReadPoint(expected, point); };
  List points;
  for (const YamlNode& item : node.items) {
    points.items.push_back(item.Find("for") != nullptr   ? ReadPointLoop(item, "at", read)
                           : item.Find("arc") != nullptr ? ReadArc(expected, item)
                                                         : read(item));
  }
  value.form = std::move(points);
  return value;
}

Value ValueReader::ReadPoint(const FieldInfo& expected, const YamlNode& node) {
  return ReadVector({.kind = FieldKind::kNumbers,
                     .min_count = expected.min_count,
                     .max_count = expected.max_count},
                    node);
}

Value ValueReader::ReadArc(const FieldInfo& expected, const YamlNode& map) {
  const bool in_space = expected.min_count == 3;
  const YamlNode& node = *map.Find("arc");
  const bool has_center = node.items.size() == 4;
  if (in_space && has_center) {
    AllowKeys(map, {"arc", "axis", "steps"}, "an arc");
  } else {
    AllowKeys(map, {"arc", "steps"}, "an arc");
  }
  if (!has_center && !(in_space && node.items.size() == 3)) {
    findings_.Add(Code::kSpecWrongLength, node.mark,
                  fmt::format("an arc is a list of its centre, its radius, and the angles where it "
                              "begins and ends{}",
                              in_space ? ", or of three of its points" : ""),
                  in_space ? "as in {arc: [[0, 0, 2cm], 2cm, -90deg, 0], axis: x}"
                           : "as in {arc: [[0, 2cm], 2cm, -90deg, 0]}");
    return SubstituteFor(map);
  }
  static constexpr FieldInfo kSteps = {
      .key = "steps", .kind = FieldKind::kInteger, .lower = 1, .upper = 1000};
  Arc arc;
  arc.center = std::make_shared<const Value>(ReadPoint(expected, node.items[0]));
  if (has_center) {
    arc.measures = ReadArcMeasures(node);
    if (in_space)
      arc.measures.push_back(ReadAxis(map, "an arc",
                                      "angles are counted from y towards z about x, from z towards "
                                      "x about y, and from x towards y about z"));
  } else {
    for (const std::size_t i : {1, 2}) arc.measures.push_back(ReadPoint(expected, node.items[i]));
  }
  const YamlNode* steps = map.Find("steps");
  arc.steps = std::make_shared<const Value>(
      steps != nullptr ? Read(kSteps, *steps) : Value{.mark = map.mark, .form = kArcSteps});
  Value value{.mark = map.mark, .components = arc.center->components};
  value.dimensions = arc.center->dimensions;
  value.form = std::move(arc);
  return value;
}

std::vector<Value> ValueReader::ReadArcMeasures(const YamlNode& arc) {
  static constexpr FieldInfo kRadius = {
      .key = "radius of an arc", .unit = "m", .lower = 0, .above = true};
  static constexpr FieldInfo kAngle = {.key = "angle of an arc", .unit = "rad"};
  std::vector<Value> measures = {Read(kRadius, arc.items[1])};
  for (const std::size_t i : {2, 3}) measures.push_back(Read(kAngle, arc.items[i]));
  return measures;
}

Value ValueReader::ReadAxis(const YamlNode& map, std::string_view what, std::string_view hint) {
  const YamlNode* axis = map.Find("axis");
  if (axis == nullptr) return {.mark = map.mark, .form = 2.0};
  constexpr std::string_view kAxes = "xyz";
  const std::size_t index = axis->text.size() == 1 ? kAxes.find(axis->text) : std::string::npos;
  if (axis->kind != YamlNode::Kind::kScalar || index == std::string::npos) {
    findings_.Add(Code::kSpecBadValue, axis->mark,
                  fmt::format("the axis of {} is none of x, y and z", what), std::string(hint));
    return SubstituteFor(*axis);
  }
  return {.mark = axis->mark, .form = static_cast<double>(index)};
}

void ValueReader::AllowKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                            std::string_view what) {
  for (const YamlNode::Pair& pair : map.pairs) {
    if (std::ranges::find(allowed, pair.key) != allowed.end()) continue;
    findings_.Add(Code::kSpecUnknownKey, pair.mark,
                  fmt::format("unknown key '{}' in {}", pair.key, what),
                  diag::DidYouMean(pair.key, allowed));
  }
}

std::vector<Loop> ValueReader::ReadLoops(const YamlNode& loops) {
  std::vector<Loop> all;
  if (loops.kind != YamlNode::Kind::kMap) {
    Wrong(loops, "loop variables, as in {i: 8}");
    return all;
  }
  for (const auto& pair : loops.pairs) {
    if (!CheckLocalName("loop variable", pair)) continue;
    std::optional<Value> list = ReadListOrName(pair.value);
    Loop loop{
        .slot = 0, .range = list ? *std::move(list) : ReadNumber(pair.value), .variable = pair.key};
    if (HasDraw(loop.range)) {
      findings_.Add(Code::kSpecConflict, loop.range.mark,
                    loop.over_values() ? "what a loop runs over cannot be drawn here"
                                       : "a loop's count cannot be drawn here",
                    "draw it as a parameter and use that parameter's name");
    }
    // A loop over a list gives its variable the dimensions of the list's values; a counter (`{i:
    // 8}`) is a plain number.
    expr::Dimensions dimensions = loop.range.dimensions;
    if (!loop.over_values()) {
      CheckPlain("a loop's count", loop.range);
      dimensions = {expr::Dimension::Count()};
    } else if (dimensions.size() > 1) {
      dimensions.clear();
    }
    loop.slot = names_.Declare(pair.key, loop.range.type, 1, std::move(dimensions)).slot;
    all.push_back(std::move(loop));
  }
  return all;
}

void ValueReader::EndLoops(const std::vector<Loop>& loops) {
  for (const Loop& loop : loops) names_.Forget(loop.variable);
}

bool ValueReader::CheckLocalName(std::string_view what, const YamlNode::Pair& pair) {
  CheckName(what, pair.key, pair.mark, findings_);
  if (!CheckNotReserved(fmt::format("a {}", what), pair.key, pair.mark, findings_)) return false;
  if (names_.Find(pair.key) == nullptr) return true;
  findings_.Add(Code::kSpecDuplicateName, pair.mark,
                fmt::format("{} '{}' hides another name", what, pair.key));
  return false;
}

}  // namespace mjforge::spec
