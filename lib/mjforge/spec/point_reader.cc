// Lists of points, and `for:`, which repeats points and entries.

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/spec/reading.h"

namespace mjforge::spec {

using diag::Code;

namespace {

constexpr double kArcSteps = 8;

}  // namespace

Value ValueReader::ReadPoints(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::kList) return Wrong(node, "a list of points [x, y]");
  Value value{.mark = node.mark, .components = static_cast<int>(node.items.size())};
  List points;
  for (const YamlNode& item : node.items) {
    points.items.push_back(item.Find("for") != nullptr   ? ReadPointLoop(item)
                           : item.Find("arc") != nullptr ? ReadArc(item)
                                                         : ReadPoint(item));
  }
  value.form = std::move(points);
  return value;
}

Value ValueReader::ReadPoint(const YamlNode& node) {
  return ReadVector({.slot = Slot::kNumbers, .min_count = 2, .max_count = 2}, node);
}

Value ValueReader::ReadPointLoop(const YamlNode& map) {
  AllowKeys(map, {"for", "at"}, "repeated points");
  const YamlNode* at = map.Find("at");
  if (at == nullptr) {
    findings_.Add(Code::kSpecMissingKey, map.mark, "repeated points without 'at'",
                  "as in {for: {i: 8}, at: [r(i), z(i)]}");
    return Harmless(map);
  }
  PointLoop points;
  std::vector<Loop> loops = ReadLoops(*map.Find("for"));
  points.at = std::make_shared<const Value>(ReadPoint(*at));
  EndLoops(loops);
  points.loops = std::make_shared<const std::vector<Loop>>(std::move(loops));
  Value value{.mark = map.mark, .components = points.at->components};
  value.dimensions = points.at->dimensions;
  value.form = std::move(points);
  return value;
}

Value ValueReader::ReadArc(const YamlNode& map) {
  AllowKeys(map, {"arc", "steps"}, "an arc");
  const YamlNode& node = *map.Find("arc");
  if (node.kind != YamlNode::Kind::kList || node.items.size() != 4) {
    findings_.Add(Code::kSpecWrongLength, node.mark,
                  "an arc is a list of its centre, its radius, and the angles where it begins and "
                  "ends",
                  "as in {arc: [[0, 2cm], 2cm, -90deg, 0]}");
    return Harmless(map);
  }
  static constexpr FieldInfo kRadius = {
      .key = "radius of an arc", .unit = "m", .lower = 0, .above = true};
  static constexpr FieldInfo kAngle = {.key = "angle of an arc", .unit = "rad"};
  static constexpr FieldInfo kSteps = {
      .key = "steps", .slot = Slot::kInteger, .lower = 1, .upper = 1000};
  Arc arc;
  arc.center = std::make_shared<const Value>(ReadPoint(node.items[0]));
  arc.measures.push_back(Read(kRadius, node.items[1]));
  for (const std::size_t i : {2, 3}) arc.measures.push_back(Read(kAngle, node.items[i]));
  const YamlNode* steps = map.Find("steps");
  arc.steps = std::make_shared<const Value>(
      steps != nullptr ? Read(kSteps, *steps) : Value{.mark = map.mark, .form = kArcSteps});
  Value value{.mark = map.mark, .components = arc.center->components};
  value.dimensions = arc.center->dimensions;
  value.form = std::move(arc);
  return value;
}

void ValueReader::AllowKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                            std::string_view what) {
  for (const YamlNode::Pair& pair : map.pairs) {
    if (std::ranges::find(allowed, pair.key) != allowed.end()) continue;
    findings_.Add(Code::kSpecUnknownKey, pair.mark,
                  fmt::format("unknown key '{}' in {}", pair.key, what),
                  diag::DidYouMean(pair.key, std::vector<std::string_view>(allowed)));
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
    // Values of a list, or a count.
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
