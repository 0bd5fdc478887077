// params: and require:. Parameters may stand in any order, so their graph is
// made from the words in them before any is compiled.

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "mjforge/spec/graph.h"
#include "mjforge/spec/reading.h"

namespace mjforge::spec {
namespace {

using diag::Code;

constexpr std::array<std::string_view, 3> kLongFormKeys = {"value", "doc", "unit"};

bool IsLongForm(const YamlNode& node) {
  return node.kind == YamlNode::Kind::kMap &&
         (node.Find("value") != nullptr || node.Find("doc") != nullptr ||
          node.Find("unit") != nullptr);
}

void CheckParameterName(const YamlNode::Pair& pair, Reading& reading) {
  CheckName("parameter", pair.key, pair.mark, reading.findings);
  CheckNotReserved("a parameter", pair.key, pair.mark, reading.findings);
  if (reading.spec.names.FindFormula(pair.key) != nullptr) {
    reading.findings.Add(Code::kSpecDuplicateName, pair.mark,
                         fmt::format("'{}' is the name of a function, too", pair.key));
  }
}

// The value without doc and unit, as the user wrote it.
std::string SourceText(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kScalar) return node.text;
  if (!IsLongForm(node)) return FlowText(node);
  if (const YamlNode* value = node.Find("value")) return SourceText(*value);
  YamlNode bare = node;
  std::erase_if(bare.pairs,
                [](const auto& pair) { return pair.key == "doc" || pair.key == "unit"; });
  return FlowText(bare);
}

// The positions of the parameters that each one's node uses, by functions, too.
std::vector<std::vector<int>> UsesOf(const std::vector<YamlNode>& nodes, const ObjectSpec& spec) {
  std::map<std::string, int, std::less<>> position;
  for (const Parameter& parameter : spec.parameters) {
    position.emplace(parameter.name, static_cast<int>(position.size()));
  }
  std::vector<std::vector<int>> uses;
  for (const YamlNode& node : nodes) {
    std::vector<std::string> names;
    CollectNames(node, names);
    std::vector<int>& used = uses.emplace_back();
    for (const std::string& name : WithNamesInFunctions(std::move(names), spec.names)) {
      const auto found = position.find(name.substr(0, name.find('.')));
      if (found != position.end()) used.push_back(found->second);
    }
  }
  return uses;
}

// What the parameters are by their own values.
std::vector<Parameter> OwnParameters(const YamlNode& params, Reading& reading) {
  ObjectSpec own;
  own.names.Declare("index", expr::Type::kNumber);
  for (const auto& [name, formula] : reading.spec.names.formulas()) own.names.Define(formula);
  diag::Findings ignored;
  Reading inner{reading.sources, ignored, own, reading.loader,
                ValueReader(own.names, reading.sources, ignored)};
  ReadParameters(&params, nullptr, {}, inner);
  reading.values.AddUses(inner.values);
  return std::move(own.parameters);
}

// A setting is of the parameter's kind: else each use of it would be found to be wrong.
void CheckSetting(const Parameter& own, const YamlNode& node, Parameter& parameter,
                  Reading& reading) {
  const Value& wanted = own.value;
  Value& value = parameter.value;
  if (wanted.components == 0) return;  // it is wrong itself
  if (value.type == wanted.type && value.components == wanted.components) return;
  if (value.components != 0) {
    const std::string given = node.kind == YamlNode::Kind::kScalar ? node.text : FlowText(node);
    reading.findings.Add(Code::kSpecWrongType, node.mark,
                         fmt::format("parameter '{}' is {}, but '{}' is {}", own.name,
                                     KindText(wanted), given, KindText(value)),
                         fmt::format("the spec has '{}: {}'", own.name, own.source));
  }
  value = Value{.mark = node.mark, .type = wanted.type, .components = wanted.components};
}

// `own`: what a setting stands in for; null: nothing was set.
void ReadOne(Parameter& parameter, const YamlNode& node, bool in_cycle, const Parameter* own,
             Reading& reading) {
  if (in_cycle) {
    parameter.slot = reading.spec.names.Declare(parameter.name, expr::Type::kNumber);
    return;
  }
  parameter.value = reading.values.ReadAnything(
      node, IsLongForm(node) ? std::span<const std::string_view>(kLongFormKeys)
                             : std::span<const std::string_view>());
  if (own != nullptr) CheckSetting(*own, node, parameter, reading);
  parameter.slot = reading.spec.names.Declare(parameter.name, parameter.value.type,
                                              std::clamp(parameter.value.components, 1, 4));
}

// A pinned text must be one the spec knows: any other would quietly leave out
// the parts that ask for it. False after a finding.
bool CheckPinnedChoice(const YamlNode& own, const YamlNode& pinned, Reading& reading) {
  const YamlNode* value = own.kind == YamlNode::Kind::kMap ? own.Find("value") : nullptr;
  const YamlNode& bare = value != nullptr ? *value : own;
  const YamlNode* options = bare.kind == YamlNode::Kind::kMap ? bare.Find("choice") : nullptr;
  if (options == nullptr || pinned.kind != YamlNode::Kind::kScalar) return true;
  std::vector<std::string_view> words;
  std::string list;
  for (const YamlNode& option : options->items) {
    if (option.kind != YamlNode::Kind::kScalar || expr::ParseNumber(option.text)) return true;
    words.push_back(option.text);
    if (!list.empty()) list += ", ";
    list += option.text;
  }
  if (std::ranges::find(words, pinned.text) != words.end()) return true;
  reading.findings.Add(Code::kSpecBadValue, pinned.mark,
                       fmt::format("'{}' is not one of {}", pinned.text, list),
                       diag::DidYouMean(pinned.text, words));
  return false;
}

// Which parameters were set.
std::vector<bool> ApplySettings(std::span<const NamedNode> settings, std::vector<YamlNode>& nodes,
                                Reading& reading) {
  std::vector<bool> is_set(nodes.size());
  std::vector<std::string_view> names;
  for (const Parameter& parameter : reading.spec.parameters) names.push_back(parameter.name);
  for (const NamedNode& setting : settings) {
    if (setting.name.starts_with(kChecksPrefix) || setting.name == kRootJoints) continue;
    const auto found = std::ranges::find(names, setting.name);
    if (found == names.end()) {
      reading.findings.Add(
          Code::kSpecUnknownParameter, setting.value.mark,
          fmt::format("'{}' has no parameter '{}'", reading.spec.name, setting.name),
          diag::DidYouMean(setting.name, names));
      continue;
    }
    const auto position = static_cast<std::size_t>(found - names.begin());
    if (!CheckPinnedChoice(nodes[position], setting.value, reading)) continue;
    is_set[position] = true;
    nodes[position] = setting.value;
    reading.spec.parameters[position].source = SourceText(setting.value);
  }
  return is_set;
}

void ReadRequirements(const YamlNode& require, Reading& reading) {
  const auto add = [&reading](const YamlNode& node) {
    if (auto condition = reading.values.ReadCondition(node)) {
      reading.spec.requirements.push_back({std::move(*condition), node.mark});
    }
  };
  if (require.kind == YamlNode::Kind::kScalar) {
    add(require);
  } else if (IsList(require, "conditions", reading)) {
    for (const YamlNode& item : require.items) add(item);
  }
}

void DeclareParameters(const YamlNode& params, std::vector<YamlNode>& nodes, Reading& reading) {
  for (const auto& pair : params.pairs) {
    CheckParameterName(pair, reading);
    Parameter parameter;
    parameter.name = pair.key;
    parameter.mark = pair.mark;
    parameter.source = SourceText(pair.value);
    if (IsLongForm(pair.value)) {
      if (const YamlNode* doc = pair.value.Find("doc")) {
        parameter.doc = reading.values.ReadPlainText("doc", *doc);
      }
      if (const YamlNode* unit = pair.value.Find("unit")) {
        parameter.unit = reading.values.ReadPlainText("unit", *unit);
      }
    }
    reading.spec.parameters.push_back(std::move(parameter));
    nodes.push_back(pair.value);
  }
}

}  // namespace

void ReadParameters(const YamlNode* params, const YamlNode* require,
                    std::span<const NamedNode> settings, Reading& reading) {
  ObjectSpec& spec = reading.spec;
  std::vector<YamlNode> nodes;
  if (params != nullptr && IsMap(*params, "parameters", reading)) {
    DeclareParameters(*params, nodes, reading);
  }
  std::vector<Parameter> own;
  if (!settings.empty() && !nodes.empty()) own = OwnParameters(*params, reading);
  const std::vector<bool> is_set = ApplySettings(settings, nodes, reading);

  std::vector<bool> in_cycle(nodes.size());
  const auto on_cycle = [&](const std::vector<int>& path) {
    std::string text;
    for (const int i : path) {
      in_cycle[static_cast<std::size_t>(i)] = true;
      if (!text.empty()) text += " -> ";
      text += spec.parameters[static_cast<std::size_t>(i)].name;
    }
    reading.findings.Add(Code::kSpecCycle, spec.parameters[static_cast<std::size_t>(path[0])].mark,
                         fmt::format("parameters depend on each other: {}", text));
  };
  spec.evaluation_order = OrderByUse(UsesOf(nodes, spec), on_cycle);
  for (const int i : spec.evaluation_order) {
    const auto at = static_cast<std::size_t>(i);
    ReadOne(spec.parameters[at], nodes[at], in_cycle[at], is_set[at] ? &own[at] : nullptr, reading);
  }
  if (require != nullptr) ReadRequirements(*require, reading);
}

}  // namespace mjforge::spec
