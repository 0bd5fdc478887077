// checks: thresholds of physical checks and findings that do not matter.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;

// The map with the settings put in.
YamlNode WithSettings(const YamlNode* checks, std::span<const NamedNode> settings) {
  YamlNode map;
  if (checks != nullptr) map = *checks;
  map.kind = YamlNode::Kind::kMap;
  for (const NamedNode& setting : settings) {
    if (!setting.name.starts_with(kChecksPrefix)) continue;
    const std::string key = setting.name.substr(kChecksPrefix.size());
    std::erase_if(map.pairs, [&](const YamlNode::Pair& pair) { return pair.key == key; });
    map.pairs.push_back({key, setting.value.mark, setting.value});
  }
  return map;
}

// A setting to nothing takes the spec's own away.
void RemoveUnset(YamlNode& map, std::span<const NamedNode> settings) {
  std::erase_if(map.pairs, [&](const YamlNode::Pair& pair) {
    return pair.value.kind == YamlNode::Kind::kNull &&
           std::ranges::any_of(settings, [&](const NamedNode& setting) {
             return setting.name.starts_with(kChecksPrefix) &&
                    setting.name.substr(kChecksPrefix.size()) == pair.key;
           });
  });
}

// A threshold that changes by chance says nothing about those who meet it.
void RejectDraw(std::string_view key, SourceMark mark, const Value& value, Reading& reading) {
  if (!HasDraw(value)) return;
  reading.findings.Add(Code::kSpecBadValue, mark,
                       fmt::format("'{}' is drawn, but a threshold must be a fixed value", key),
                       "draw it as a parameter, and use that parameter's name here");
}

void RejectDraws(const std::vector<Field>& fields, Reading& reading) {
  for (const Field& field : fields) RejectDraw(field.info->key, field.mark, field.value, reading);
}

/// A text that says something.
std::string ReadReason(std::string_view key, const YamlNode& reason, std::string_view what,
                       Reading& reading) {
  if (reason.kind == YamlNode::Kind::kScalar && Trim(reason.text).empty()) {
    reading.findings.Add(Code::kSpecBadValue, reason.mark,
                         fmt::format("no reason is given {}", what));
  }
  return reading.values.ReadPlainText(key, reason);
}

void ReadHolding(const YamlNode& holds, Reading& reading) {
  if (!IsMap(holds, "what is dropped into the object", reading)) return;
  CheckKeys(HoldingElement(), holds, reading);
  Checks::Holding& holding = reading.spec.checks.holds.emplace();
  holding.mark = holds.mark;
  holding.fields = ReadFields(HoldingElement(), holds, reading);
  RejectDraws(holding.fields, reading);
  if (holds.Find("ball") == nullptr)
    reading.findings.Add(Code::kSpecMissingKey, holds.mark, "'ball' is missing",
                         "it is the balls' diameter: {ball: 8mm}");
}

void ReadFitting(const YamlNode& map, EntryReader& entries, Reading& reading) {
  if (!IsMap(map, "what must go into a hole", reading)) return;
  CheckKeys(FittingElement(), map, reading);
  Checks::Fitting fitting;
  fitting.entry = entries.Begin(FittingElement(), map, map, EntryReader::Naming::kOptional);
  fitting.entry.fields = ReadFields(FittingElement(), map, reading);
  RejectDraws(fitting.entry.fields, reading);
  entries.End(fitting.entry);
  const auto missing = [&](std::string_view key, std::string_view hint) {
    reading.findings.Add(Code::kSpecMissingKey, map.mark, fmt::format("'{}' is missing", key),
                         std::string(hint));
  };
  const bool has_body = map.Find("body") != nullptr;
  if (map.Find("hole") == nullptr) missing("hole", "the site at its mouth, z axis inwards");
  if (map.Find("depth") == nullptr) missing("depth", "how far in it must get: {depth: 2cm}");
  if (has_body && map.Find("tip") == nullptr) missing("tip", "a site of the body");
  if (!has_body && map.Find("peg") == nullptr)
    missing("peg", "its diameter, {peg: 9.8mm}; or a `body` of the object with its `tip`");
  if (has_body && map.Find("peg") != nullptr) {
    reading.findings.Add(Code::kSpecConflict, map.mark,
                         "'peg' together with 'body': one of them goes into the hole");
  }
  reading.spec.checks.fits.push_back(std::move(fitting));
}

/// A text or a list of texts.
std::vector<Value> ReadNames(const YamlNode* names, Reading& reading) {
  std::vector<Value> texts;
  if (names == nullptr) return texts;
  if (names->kind != YamlNode::Kind::kList) return {reading.values.ReadText(*names)};
  for (const YamlNode& name : names->items) texts.push_back(reading.values.ReadText(name));
  return texts;
}

void ReadGrasping(const YamlNode& grasps, Reading& reading) {
  if (!IsMap(grasps, "how the object is held", reading)) return;
  CheckKeys(GraspingElement(), grasps, reading);
  Checks::Grasping& grasping = reading.spec.checks.grasps.emplace();
  grasping.mark = grasps.mark;
  grasping.fields = ReadFields(GraspingElement(), grasps, reading);
  grasping.sites = ReadNames(grasps.Find("sites"), reading);
  RejectDraws(grasping.fields, reading);
}

void ReadPartCheck(const YamlNode& map, EntryReader& entries, Reading& reading) {
  if (!IsMap(map, "a part and what is asked of it", reading)) return;
  CheckKeys(PartCheckElement(), map, reading);
  Checks::PartCheck check;
  check.entry = entries.Begin(PartCheckElement(), map, map, EntryReader::Naming::kOptional);
  check.entry.fields = ReadFields(PartCheckElement(), map, reading);
  RejectDraws(check.entry.fields, reading);
  check.parts = ReadNames(map.Find("part"), reading);
  if (check.parts.empty())
    reading.findings.Add(Code::kSpecMissingKey, map.mark, "'part' is missing",
                         "the name of a part, or a list of names");
  entries.End(check.entry);
  reading.spec.checks.parts.push_back(std::move(check));
}

void ReadJointCheck(const YamlNode& map, EntryReader& entries, Reading& reading) {
  if (!IsMap(map, "a joint and what is asked of it", reading)) return;
  CheckKeys(JointCheckElement(), map, reading);
  Checks::JointCheck check;
  check.entry = entries.Begin(JointCheckElement(), map, map, EntryReader::Naming::kOptional);
  check.entry.fields = ReadFields(JointCheckElement(), map, reading);
  RejectDraws(check.entry.fields, reading);
  check.joints = ReadNames(map.Find("joint"), reading);
  if (check.joints.empty())
    reading.findings.Add(Code::kSpecMissingKey, map.mark, "'joint' is missing",
                         "the name of a joint, or a list of names");
  if (const YamlNode* at = map.Find("at")) {
    check.at = ReadPositions(*at, reading);
    for (const Position& position : check.at)
      RejectDraw("at", position.mark, position.value, reading);
  }
  if (const YamlNode* skip = map.Find("skip"))
    check.skip = ReadReason("skip", *skip, "why it is not driven", reading);
  entries.End(check.entry);
  reading.spec.checks.joints.push_back(std::move(check));
}

void ReadSilence(const YamlNode& silence, Reading& reading) {
  if (!IsMap(silence, "codes and reasons", reading)) return;
  std::vector<std::string_view> names;
  for (const diag::CodeInfo& info : diag::AllCodes()) {
    if (CanBeSilenced(info.code)) names.push_back(info.name);
  }
  for (const YamlNode::Pair& pair : silence.pairs) {
    const auto codes = diag::AllCodes();
    const auto found = std::ranges::find(codes, pair.key, &diag::CodeInfo::name);
    if (found == codes.end() || !CanBeSilenced(found->code)) {
      const std::string hint = diag::DidYouMean(pair.key, names);
      reading.findings.Add(
          Code::kSpecUnknownKey, pair.mark,
          fmt::format("'{}' is not a finding that can be silenced", pair.key),
          hint.empty() ? "docs/errors.md lists them: physics/... and spec/unused" : hint);
      continue;
    }
    const std::string what = fmt::format("why '{}' does not matter", pair.key);
    reading.spec.checks.silenced.push_back(
        {found->code, ReadReason(pair.key, pair.value, what, reading)});
  }
}

}  // namespace

bool CanBeSilenced(diag::Code code) {
  return code == Code::kSpecUnused || diag::CodeName(code).starts_with("physics/");
}

void ReadChecks(const YamlNode* checks, std::span<const NamedNode> settings, Reading& reading) {
  if (checks != nullptr && !IsMap(*checks, "checks", reading)) return;
  YamlNode map = WithSettings(checks, settings);
  CheckKeys(ChecksElement(), map, reading);
  RemoveUnset(map, settings);
  reading.spec.checks.fields = ReadFields(ChecksElement(), map, reading);
  RejectDraws(reading.spec.checks.fields, reading);
  if (const YamlNode* silence = map.Find("silence")) ReadSilence(*silence, reading);
  if (const YamlNode* holds = map.Find("holds")) ReadHolding(*holds, reading);
  if (const YamlNode* grasps = map.Find("grasps")) ReadGrasping(*grasps, reading);
  EntryReader entries(reading);
  const auto read = [&](std::string_view key, std::string_view what, auto read_one) {
    const YamlNode* list = map.Find(key);
    if (list == nullptr || !IsList(*list, what, reading)) return;
    for (const YamlNode& item : list->items) read_one(item, entries, reading);
  };
  read("fits", "what must go into holes", ReadFitting);
  read("parts", "parts and what is asked of them", ReadPartCheck);
  read("joints", "joints and what is asked of them", ReadJointCheck);
}

}  // namespace mjforge::spec
