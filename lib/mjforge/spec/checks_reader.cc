// Reader of `checks:`: thresholds and objects of the physical checks, and findings to ignore.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;

// Returns the mapping `checks:` after replacing its values by the settings `checks.KEY`. A setting
// with the value null removes the key, and the default then applies.
YamlNode WithSettings(const YamlNode* checks, std::span<const SettingNode> settings) {
  YamlNode map;
  if (checks != nullptr) map = *checks;
  map.kind = YamlNode::Kind::kMap;
  for (const SettingNode& setting : settings) {
    if (!setting.name.starts_with(kChecksPrefix)) continue;
    const std::string key = setting.name.substr(kChecksPrefix.size());
    std::erase_if(map.pairs, [&](const YamlNode::Pair& pair) { return pair.key == key; });
    const bool is_null = setting.value.kind == YamlNode::Kind::kNull;
    if (is_null && kChecksElement.Find(key) != nullptr) continue;
    map.pairs.push_back({key, setting.value.mark, setting.value});
  }
  return map;
}

// Reports a threshold that is drawn: the results of variants with different thresholds could not be
// compared.
void RejectDraw(std::string_view key, SourceMark mark, const Value& value, Context& context) {
  if (!HasDraw(value)) return;
  context.findings.Add(Code::kSpecBadValue, mark,
                       fmt::format("'{}' is drawn, but a threshold must be a fixed value", key),
                       "draw it as a parameter, and use that parameter's name here");
}

// Reads the reason for a skipped or silenced check; reports a blank reason.
std::string ReadReason(std::string_view key, const YamlNode& reason, std::string_view what,
                       Context& context) {
  if (reason.kind == YamlNode::Kind::kScalar && Trim(reason.text).empty()) {
    context.findings.Add(Code::kSpecBadValue, reason.mark,
                         fmt::format("no reason is given {}", what));
  }
  return context.values.ReadPlainText(key, reason);
}

// Returns the fields of a mapping, and reports drawn values among them.
std::vector<Field> ReadThresholds(const ElementInfo& element, const YamlNode& map,
                                  Context& context) {
  CheckKeys(element, map, context);
  std::vector<Field> fields = ReadFields(element, map, context);
  for (const Field& field : fields) RejectDraw(field.info->key, field.mark, field.value, context);
  return fields;
}

void RequireKey(std::string_view key, std::string_view hint, const YamlNode& map,
                Context& context) {
  if (map.Find(key) != nullptr) return;
  context.findings.Add(Code::kSpecMissingKey, map.mark, fmt::format("'{}' is missing", key),
                       std::string(hint));
}

void ReadHolding(const YamlNode& holds, Context& context) {
  if (!IsMap(holds, "what is dropped into the object", context)) return;
  context.spec.checks.holds =
      Checks::Group{ReadThresholds(kHoldingElement, holds, context), holds.mark};
  RequireKey("ball", "it is the balls' diameter: {ball: 8mm}", holds, context);
}

void ReadSettling(const YamlNode& settled, Context& context) {
  if (!IsMap(settled, "how far bodies may move", context)) return;
  context.spec.checks.settled =
      Checks::Group{ReadThresholds(kSettlingElement, settled, context), settled.mark};
}

// Reads the names in a text or a list of texts; `names` may be null.
std::vector<Value> ReadNames(const YamlNode* names, Context& context) {
  std::vector<Value> texts;
  if (names == nullptr) return texts;
  if (names->kind != YamlNode::Kind::kList) return {context.values.ReadText(*names)};
  for (const YamlNode& name : names->items) texts.push_back(context.values.ReadText(name));
  return texts;
}

void ReadGrasping(const YamlNode& grasps, Context& context) {
  if (!IsMap(grasps, "how the object is held", context)) return;
  context.spec.checks.grasps =
      Checks::Grasping{ReadThresholds(kGraspingElement, grasps, context),
                       ReadNames(grasps.Find("sites"), context), grasps.mark};
}

const Entry& ReadFitting(const YamlNode& map, Entry entry, Context& context) {
  const bool has_body = map.Find("body") != nullptr;
  RequireKey("hole", "the site at its mouth, z axis inwards", map, context);
  RequireKey("depth", "how far in it must get: {depth: 2cm}", map, context);
  if (has_body) {
    RequireKey("tip", "a site of the body", map, context);
  } else {
    RequireKey("peg", "its diameter, {peg: 9.8mm}; or a `body` of the object with its `tip`", map,
               context);
  }
  if (has_body && map.Find("peg") != nullptr) {
    context.findings.Add(Code::kSpecConflict, map.mark,
                         "'peg' together with 'body': one of them goes into the hole");
  }
  return context.spec.checks.fits.emplace_back(Checks::Fitting{std::move(entry)}).entry;
}

const Entry& ReadPartCheck(const YamlNode& map, Entry entry, Context& context) {
  auto& check = context.spec.checks.parts.emplace_back(
      Checks::PartCheck{std::move(entry), ReadNames(map.Find("part"), context)});
  if (check.parts.empty())
    context.findings.Add(Code::kSpecMissingKey, map.mark, "'part' is missing",
                         "the name of a part, or a list of names");
  return check.entry;
}

const Entry& ReadJointCheck(const YamlNode& map, Entry entry, Context& context) {
  auto& check = context.spec.checks.joints.emplace_back();
  check.entry = std::move(entry);
  check.joints = ReadNames(map.Find("joint"), context);
  if (check.joints.empty())
    context.findings.Add(Code::kSpecMissingKey, map.mark, "'joint' is missing",
                         "the name of a joint, or a list of names");
  if (const YamlNode* at = map.Find("at")) {
    check.at = ReadPositions(*at, context);
    for (const JointPosition& position : check.at)
      RejectDraw("at", position.mark, position.value, context);
  }
  if (const YamlNode* skip = map.Find("skip"))
    check.skip = ReadReason("skip", *skip, "why it is not driven", context);
  return check.entry;
}

void ReadSilence(const YamlNode& silence, Context& context) {
  if (!IsMap(silence, "codes and reasons", context)) return;
  std::vector<std::string_view> names;
  for (const diag::CodeInfo& info : diag::AllCodes()) {
    if (CanBeSilenced(info.code)) names.push_back(info.name);
  }
  for (const YamlNode::Pair& pair : silence.pairs) {
    const auto codes = diag::AllCodes();
    const auto found = std::ranges::find(codes, pair.key, &diag::CodeInfo::name);
    if (found == codes.end() || !CanBeSilenced(found->code)) {
      const std::string hint = diag::DidYouMean(pair.key, names);
      context.findings.Add(
          Code::kSpecUnknownKey, pair.mark,
          fmt::format("'{}' is not a finding that can be silenced", pair.key),
          hint.empty() ? "docs/errors.md lists them: physics/... and spec/unused" : hint);
      continue;
    }
    const std::string what = fmt::format("why '{}' does not matter", pair.key);
    context.spec.checks.silenced.push_back(
        {found->code, ReadReason(pair.key, pair.value, what, context)});
  }
}

}  // namespace

bool CanBeSilenced(diag::Code code) {
  return code == Code::kSpecUnused || diag::CodeName(code).starts_with("physics/");
}

void ReadChecks(const YamlNode* checks, std::span<const SettingNode> settings, Context& context) {
  if (checks != nullptr && !IsMap(*checks, "checks", context)) return;
  const YamlNode map = WithSettings(checks, settings);
  context.spec.checks.fields = ReadThresholds(kChecksElement, map, context);
  if (const YamlNode* silence = map.Find("silence")) ReadSilence(*silence, context);
  if (const YamlNode* holds = map.Find("holds")) ReadHolding(*holds, context);
  if (const YamlNode* settled = map.Find("settled")) ReadSettling(*settled, context);
  if (const YamlNode* grasps = map.Find("grasps")) ReadGrasping(*grasps, context);
  EntryReader entries(context);
  const auto read = [&](std::string_view key, const ElementInfo& element, std::string_view what,
                        std::string_view what_of_one, auto add) {
    const YamlNode* list = map.Find(key);
    if (list == nullptr || !IsList(*list, what, context)) return;
    for (const YamlNode& item : list->items) {
      if (!IsMap(item, what_of_one, context)) continue;
      Entry entry = entries.Begin(element, item, item);
      entry.fields = ReadThresholds(element, item, context);
      entries.End(add(item, std::move(entry), context));
    }
  };
  read("fits", kFittingElement, "what must go into holes", "what must go into a hole", ReadFitting);
  read("parts", kPartCheckElement, "parts and what is asked of them",
       "a part and what is asked of it", ReadPartCheck);
  read("joints", kJointCheckElement, "joints and what is asked of them",
       "a joint and what is asked of it", ReadJointCheck);
}

}  // namespace mjforge::spec
