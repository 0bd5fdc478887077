// checks: thresholds of physical checks and findings that do not matter.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;

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

// A threshold that changes by chance says nothing about those who meet it.
void RejectDraws(const std::vector<Field>& fields, Reading& reading) {
  for (const Field& field : fields) {
    if (!HasDraw(field.value)) continue;
    reading.findings.Add(
        Code::kSpecBadValue, field.mark,
        fmt::format("'{}' is drawn, but a threshold must be a fixed value", field.info->key),
        "draw it as a parameter, and use that parameter's name here");
  }
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
    std::string reason = reading.values.ReadPlainText("reason", pair.value);
    if (Trim(reason).empty() && pair.value.kind == YamlNode::Kind::kScalar) {
      reading.findings.Add(Code::kSpecBadValue, pair.value.mark,
                           fmt::format("no reason is given why '{}' does not matter", pair.key));
    }
    reading.spec.checks.silenced.push_back({found->code, std::move(reason)});
  }
}

}  // namespace

bool CanBeSilenced(diag::Code code) {
  return code == Code::kSpecUnused || diag::CodeName(code).starts_with("physics/");
}

void ReadChecks(const YamlNode* checks, std::span<const NamedNode> settings, Reading& reading) {
  if (checks != nullptr && !IsMap(*checks, "checks", reading)) return;
  const YamlNode map = WithSettings(checks, settings);
  CheckKeys(ChecksElement(), map, reading);
  reading.spec.checks.fields = ReadFields(ChecksElement(), map, reading);
  RejectDraws(reading.spec.checks.fields, reading);
  if (const YamlNode* silence = map.Find("silence")) ReadSilence(*silence, reading);
  if (const YamlNode* holds = map.Find("holds")) ReadHolding(*holds, reading);
}

}  // namespace mjforge::spec
