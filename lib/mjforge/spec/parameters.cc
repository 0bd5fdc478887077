// Reader of `params:` and `require:`. Parameters are read after the parameters that they use.

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/spec/record_parameters.h"
#include "mjforge/spec/topological_order.h"

namespace mjforge::spec {
namespace {

using diag::Code;

constexpr std::array<std::string_view, 4> kLongFormKeys = {"value", "doc", "unit", "section"};

bool IsLongForm(const YamlNode& node) {
  return std::ranges::any_of(kLongFormKeys,
                             [&](std::string_view key) { return node.Find(key) != nullptr; });
}

void CheckParameterName(const YamlNode::Pair& pair, Context& context) {
  CheckName("parameter", pair.key, pair.mark, context.findings);
  CheckNotReserved("a parameter", pair.key, pair.mark, context.findings);
  if (context.spec.names.FindFunction(pair.key) != nullptr) {
    context.findings.Add(Code::kSpecDuplicateName, pair.mark,
                         fmt::format("'{}' is the name of a function, too", pair.key));
  }
}

// Returns the text of a parameter's value as the user wrote it, without `doc`, `unit` and
// `section`.
std::string SourceText(const YamlNode& node) {
  if (node.kind == YamlNode::Kind::kScalar && !IsQuotedNumber(node)) return node.text;
  if (!IsLongForm(node)) return FlowText(node);
  if (const YamlNode* value = node.Find("value")) return SourceText(*value);
  YamlNode bare = node;
  std::erase_if(bare.pairs, [](const auto& pair) { return IsAnnotationKey(pair.key); });
  return FlowText(bare);
}

// Returns, for each parameter, the indices of the parameters that it uses, directly or through
// functions. Searches the source text for names, because expressions are compiled only after the
// order is known.
Dependencies UsesOf(const std::vector<ParameterNode>& declared, const expr::SymbolTable& names) {
  std::map<std::string, std::size_t, std::less<>> position;
  for (const ParameterNode& parameter : declared) position.emplace(parameter.name, position.size());
  Dependencies uses;
  std::size_t key = 0;
  for (const ParameterNode& parameter : declared) {
    std::vector<std::size_t>& used = uses.emplace_back();
    if (parameter.is_key()) key = uses.size() - 1;
    if (parameter.rows != nullptr && !parameter.is_key()) used.push_back(key);
    std::vector<std::string> words;
    // Skips the cells of a CSV table, which are not expressions.
    for (const YamlNode::Pair& pair : parameter.value.pairs) {
      if (!IsAnnotationKey(pair.key) &&
          (parameter.kind == FieldKind::kAnything || pair.key != "choice"))
        CollectNames(pair.value, words);
    }
    if (parameter.value.kind != YamlNode::Kind::kMap) CollectNames(parameter.value, words);
    for (const std::string& word : WithNamesInFunctions(std::move(words), names)) {
      auto found = position.find(word);
      if (found == position.end()) found = position.find(word.substr(0, word.find('.')));
      if (found != position.end()) used.push_back(found->second);
    }
  }
  return uses;
}

// Returns the parameters with the values that the spec gives them, before settings replace any.
std::vector<Parameter> OwnParameters(const YamlNode& params, Context& context) {
  ObjectSpec own;
  own.shared = context.spec.shared;
  DeclareIndex(own.names);
  for (const auto& [name, function] : context.spec.names.functions()) own.names.Define(function);
  diag::Findings ignored;
  Context inner{context.sources, ignored, own, context.loader,
                ValueReader(own.names, context.sources, ignored)};
  ReadParameters(&params, nullptr, {}, inner);
  context.values.AddUses(inner.values);
  return std::move(own.parameters);
}

// Reports a setting whose kind or unit differs from that of the value in the spec. Replaces a
// setting of another kind by a value of the kind in the spec, so that uses of the parameter are not
// reported as well.
void CheckSetting(const Parameter& own, const YamlNode& node, Parameter& parameter,
                  Context& context) {
  const Value& wanted = own.value;
  Value& value = parameter.value;
  if (wanted.components == 0) return;  // the value in the spec is wrong, and was reported
  if (IsSameKind(value, wanted)) {
    const bool fits =
        context.values.CheckUnit(fmt::format("parameter '{}'", own.name), wanted.dimensions, value);
    if (!fits || IsMeasured(wanted.dimensions)) value.dimensions = wanted.dimensions;
    return;
  }
  if (value.components != 0) {
    const std::string given = node.kind == YamlNode::Kind::kScalar ? node.text : FlowText(node);
    context.findings.Add(Code::kSpecWrongType, node.mark,
                         fmt::format("parameter '{}' is {}, but '{}' is {}", own.name,
                                     KindText(wanted), given, KindText(value)),
                         fmt::format("the spec has '{}: {}'", own.name, own.source));
  }
  value = Value{.mark = node.mark,
                .type = wanted.type,
                .components = wanted.components,
                .is_list = wanted.is_list};
}

// Returns a list of words, "M3, M4, M5"; for a long list, the first words and the count of all.
std::string SomeOf(std::span<const std::string> words) {
  constexpr std::size_t kShown = 12;
  std::string text =
      fmt::format("{}", fmt::join(words.first(std::min(kShown, words.size())), ", "));
  return words.size() > kShown ? fmt::format("{}, ... ({} in all)", text, words.size()) : text;
}

// Reports a setting that sets the key of a record to a constant that is in no row.
void CheckKey(const ParameterNode& declared, const Value& value, Context& context) {
  const auto number = ConstantOf(value);
  if (!number || declared.rows->numbers.contains(*number)) return;
  context.findings.Add(
      Code::kSpecBadValue, value.mark,
      fmt::format("no row of '{}' has {}", declared.record, expr::NumberText(*number)),
      fmt::format("the rows are {}", SomeOf(declared.rows->names)));
}

// Reports a unit that is not an SI unit, because the values of parameters are in SI units.
void CheckIsSi(const Parameter& parameter, diag::SourceMark mark, Context& context) {
  const auto unit = expr::FindUnit(parameter.unit);
  if (!unit || unit->is_si) return;
  const std::string si = unit->dimension.Text();
  context.findings.Add(
      Code::kSpecBadValue, mark,
      fmt::format("'{}' is not a unit of parameters, whose values are in {}", parameter.unit, si),
      fmt::format("write `unit: {}`, and 15{} for 15 {}", si, parameter.unit, parameter.unit));
}

// Reports `unit:` of a setting that differs from the unit of the parameter.
void CheckUnitOfSetting(const Parameter& own, const YamlNode& setting, Context& context) {
  const YamlNode* node = setting.Find("unit");
  if (node == nullptr || own.value.type != expr::Type::kNumber) return;
  Parameter given;
  given.unit = context.values.ReadPlainText("unit", *node);
  CheckIsSi(given, node->mark, context);
  const auto dimensions = DimensionsOf(given.unit);
  if (!dimensions) return;
  context.values.CheckUnit(fmt::format("parameter '{}'", own.name), own.value.dimensions,
                           {.mark = node->mark, .dimensions = *dimensions});
}

// Assigns the dimensions of a parameter's unit to its value, and reports a value of other
// dimensions.
void ApplyUnit(Parameter& parameter, Context& context) {
  Value& value = parameter.value;
  if (value.type != expr::Type::kNumber) return;
  const auto wanted = DimensionsOf(parameter.unit);
  if (wanted) {
    context.values.CheckUnit(fmt::format("parameter '{}'", parameter.name), *wanted, value);
    value.dimensions = *wanted;
  } else if (parameter.unit.empty() && IsMeasured(value.dimensions)) {
    parameter.unit = UnitText(value.dimensions);
  }
}

// Returns true if a setting is one of the texts among which the spec chooses, and has names of
// parameters at most among its words.
bool IsOption(const Value& own, const YamlNode& setting) {
  const auto* draw = std::get_if<Draw>(&own.form);
  if (draw == nullptr || own.type != expr::Type::kText || expr::IsName(setting.text)) return false;
  const auto is_same = [&](const Value& option) { return LiteralText(option) == setting.text; };
  return std::ranges::any_of(draw->arguments, is_same);
}

// Reads the value of a parameter. `own` is the parameter as the spec declares it, if a setting
// replaces its value; otherwise null. `key` is the key of a record if the parameter is another
// column of the record; otherwise null.
void ReadOne(Parameter& parameter, const ParameterNode& declared, const Parameter* own,
             const Parameter* key, Context& context) {
  const YamlNode& node = declared.value;
  const std::span<const std::string_view> extra_keys =
      IsLongForm(node) ? std::span(kLongFormKeys) : std::span<const std::string_view>();
  if (own != nullptr) {
    parameter.value = node.kind == YamlNode::Kind::kScalar && IsOption(own->value, node)
                          ? context.values.ReadText(node)
                          : context.values.ReadLike(own->value, node, extra_keys);
    const std::size_t before = context.findings.size();
    CheckSetting(*own, node, parameter, context);
    const bool is_good = context.findings.size() == before;
    if (is_good && IsLongForm(node)) CheckUnitOfSetting(*own, node, context);
    if (declared.is_key()) CheckKey(declared, parameter.value, context);
  } else if (key != nullptr) {
    parameter.value = context.values.ReadDrawOf(declared.kind, node);
    if (auto* choice = std::get_if<Draw>(&parameter.value.form)) {
      choice->rows = declared.rows;
      choice->key_slot = key->slot;
    }
  } else if (declared.is_key()) {
    parameter.value = context.values.ReadDrawOf(declared.kind, node, extra_keys);
  } else {
    parameter.value = context.values.ReadAnything(node, extra_keys);
  }
  ApplyUnit(parameter, context);
  const auto& variable = Declare(context.spec.names, parameter.name, parameter.value);
  parameter.slot = variable.slot;
  parameter.list = variable.list;
}

// Returns false, and adds a finding, if a parameter that chooses from texts is set to a text that
// is not an option. Otherwise parts with a condition on the text would be left out without a
// message.
bool CheckPinnedChoice(const YamlNode& own, const YamlNode& pinned, Context& context) {
  const YamlNode* options = WithoutLongForm(own).Find("choice");
  if (options == nullptr || pinned.kind != YamlNode::Kind::kScalar) return true;
  if (pinned.text.find("${") != std::string::npos) return true;  // a text that is not known yet
  std::vector<std::string> words;
  for (const YamlNode& option : options->items) {
    if (!context.values.IsPlainText(option)) return true;
    words.push_back(option.text);
  }
  if (std::ranges::find(words, pinned.text) != words.end()) return true;
  context.findings.Add(Code::kSpecBadValue, pinned.mark,
                       fmt::format("'{}' is not one of {}", pinned.text, SomeOf(words)),
                       diag::DidYouMean(pinned.text, words));
  return false;
}

// Replaces the YAML values of parameters by their settings. Returns a flag for each parameter: true
// if a setting replaced its value.
std::vector<bool> ApplySettings(std::span<const SettingNode> settings,
                                std::vector<ParameterNode>& declared, Context& context) {
  std::vector<bool> is_set(declared.size());
  for (const SettingNode& setting : settings) {
    if (setting.name.starts_with(kChecksPrefix) || setting.name == kRootJoints ||
        setting.name == kRootStart) {
      continue;
    }
    const Parameter* found = context.spec.FindParameter(setting.name);
    if (found == nullptr) {
      context.findings.Add(
          Code::kSpecUnknownParameter, setting.value.mark,
          fmt::format("'{}' has no parameter '{}'", context.spec.name, setting.name),
          diag::DidYouMean(setting.name, context.spec.parameters, &Parameter::name));
      continue;
    }
    const auto at = static_cast<std::size_t>(found - context.spec.parameters.data());
    const std::size_t first = context.spec.parameters.size() - declared.size();
    if (at < first) continue;  // applied when the imported file was read
    const std::size_t position = at - first;
    const bool is_looked_up = declared[position].rows != nullptr && !declared[position].is_key();
    if (!is_looked_up && !CheckPinnedChoice(declared[position].value, setting.value, context))
      continue;
    is_set[position] = true;
    declared[position].value = setting.value;
    context.spec.parameters[at].source = SourceText(setting.value);
  }
  return is_set;
}

// Returns the key of the record of which parameter `i` is another column; null if there is none.
const Parameter* KeyOf(std::span<const ParameterNode> declared, std::size_t i,
                       std::span<const Parameter> parameters) {
  if (declared[i].rows == nullptr || declared[i].is_key()) return nullptr;
  while (!declared[i].is_key()) --i;
  return &parameters[i];
}

// Adds the parameters and functions of imported files, except those with names that the spec itself
// defines.
void AddShared(const YamlNode* params, Context& context) {
  ObjectSpec& spec = context.spec;
  for (std::size_t file = 0; file < spec.shared.size(); ++file) {
    const ObjectSpec& from = *spec.shared[file];
    spec.draws |= from.draws;
    for (const auto& [name, function] : from.names.functions()) {
      if (spec.names.FindFunction(name) == nullptr) spec.names.Define(function);
    }
    for (std::size_t i = 0; i < from.parameters.size(); ++i) {
      const Parameter& theirs = from.parameters[i];
      const bool is_own = params != nullptr &&
                          params->Find(theirs.name.substr(0, theirs.name.find('.'))) != nullptr;
      if (is_own || spec.FindParameter(theirs.name) != nullptr) continue;
      Parameter& parameter = spec.parameters.emplace_back(theirs);
      parameter.value.form = SharedParameter{file, i};
      const auto& variable = Declare(spec.names, parameter.name, parameter.value);
      parameter.slot = variable.slot;
      parameter.list = variable.list;
      spec.evaluation_order.push_back(static_cast<int>(spec.parameters.size()) - 1);
    }
  }
}

void ReadRequirements(const YamlNode& require, Context& context) {
  for (const YamlNode& node : OneOrMore(require, "conditions", context)) {
    if (auto condition = context.values.ReadCondition(node))
      context.spec.requirements.push_back({std::move(*condition), node.mark});
  }
}

// Reads `doc`, `unit` and `section` of a parameter's long form.
void ReadAboutValue(const YamlNode& node, Parameter& parameter, Context& context) {
  if (const YamlNode* doc = node.Find("doc"))
    parameter.doc = context.values.ReadPlainText("doc", *doc);
  if (const YamlNode* unit = node.Find("unit")) {
    parameter.unit = context.values.ReadPlainText("unit", *unit);
    CheckIsSi(parameter, unit->mark, context);
  }
  const YamlNode* section = node.Find("section");
  if (section == nullptr) return;
  parameter.section = context.values.ReadPlainText("section", *section);
  if (section->kind == YamlNode::Kind::kScalar && section->text.empty())
    context.findings.Add(Code::kSpecBadValue, section->mark, "'section' is empty",
                         "name the heading, as in `section: Handle`");
}

std::vector<ParameterNode> DeclareParameters(const YamlNode& params, Context& context) {
  std::vector<ParameterNode> all;
  for (const auto& pair : params.pairs) {
    CheckParameterName(pair, context);
    auto record = ReadRecord(pair, context);
    if (!record) {
      record.emplace(
          {ParameterNode{.name = pair.key, .mark = pair.mark, .value = pair.value, .source = {}}});
    }
    const std::size_t first = context.spec.parameters.size();
    for (ParameterNode& declared : *record) {
      Parameter parameter;
      parameter.name = declared.name;
      parameter.mark = declared.mark;
      parameter.source =
          declared.source.empty() ? SourceText(pair.value) : std::move(declared.source);
      parameter.record = declared.record;
      parameter.unit = declared.unit;
      if (&declared != &record->front())
        parameter.section = context.spec.parameters[first].section;
      else if (IsLongForm(pair.value))
        ReadAboutValue(pair.value, parameter, context);
      context.spec.parameters.push_back(std::move(parameter));
      all.push_back(std::move(declared));
    }
  }
  return all;
}

}  // namespace

void ReadParameters(const YamlNode* params, const YamlNode* require,
                    std::span<const SettingNode> settings, Context& context) {
  ObjectSpec& spec = context.spec;
  AddShared(params, context);
  const std::size_t first = spec.parameters.size();
  std::vector<ParameterNode> declared;
  if (params != nullptr && IsMap(*params, "parameters", context)) {
    declared = DeclareParameters(*params, context);
  }
  std::vector<Parameter> own;
  if (!settings.empty() && !declared.empty()) own = OwnParameters(*params, context);
  const std::vector<bool> is_set = ApplySettings(settings, declared, context);
  const std::span<Parameter> parameters = std::span(spec.parameters).subspan(first);

  std::vector<bool> in_cycle(declared.size());
  const auto on_cycle = [&](const std::vector<std::size_t>& path) {
    const auto name = [&](std::size_t i) { return std::string_view(parameters[i].name); };
    diag::SourceMark mark = parameters[path[0]].mark;
    for (const std::size_t i : path) {
      in_cycle[i] = true;
      if (is_set[i]) mark = declared[i].value.mark;
    }
    context.findings.Add(
        Code::kSpecCycle, mark,
        fmt::format("parameters depend on each other: {}", diag::Joined(path, " -> ", name)));
  };
  for (const std::size_t at : TopologicalOrder(UsesOf(declared, spec.names), on_cycle)) {
    spec.evaluation_order.push_back(static_cast<int>(first + at));
    if (in_cycle[at]) {
      parameters[at].slot = spec.names.Declare(parameters[at].name, expr::Type::kNumber).slot;
    } else {
      ReadOne(parameters[at], declared[at], is_set[at] ? &own[first + at] : nullptr,
              KeyOf(declared, at, parameters), context);
    }
  }
  if (require != nullptr) ReadRequirements(*require, context);
}

}  // namespace mjforge::spec
