// Reader of parts, sites, regions, cameras, lights and joints, with frames and nested specs.

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Collects the names of entries that exist in every variant, and reports repeated names.
void CollectSure(std::string_view what, std::span<const Entry> entries,
                 std::map<std::string_view, diag::SourceMark>& seen, Context& context) {
  for (const Entry& entry : entries) {
    if (entry.condition || !entry.loops.empty()) continue;
    if (entry.is_frame) {
      CollectSure(what, entry.children, seen, context);
      continue;
    }
    const auto name = LiteralText(entry.name);
    if (!name || name->empty()) continue;
    const auto [first, is_new] = seen.emplace(*name, entry.name.mark);
    if (is_new) continue;
    context.findings
        .Add(Code::kSpecDuplicateName, entry.name.mark,
             fmt::format("two {}s are named '{}'", what, *name))
        .notes.push_back({first->second, "the other one"});
  }
}

bool HasMaterial(const ObjectSpec& spec, std::string_view name) {
  return std::ranges::find(spec.materials, name, &Material::name) != spec.materials.end();
}

// Adds the fields of `defaults` to an entry, except fields that the entry itself has or that its
// own fields exclude (`mass` excludes a default density).
void AddDefaults(std::span<const Field> defaults, Entry& entry) {
  const std::size_t own = entry.fields.size();
  for (const Field& field : defaults) {
    const auto says_it = [&](const Field& said) {
      return ExcludeEachOther(*said.info, *field.info);
    };
    if (std::ranges::any_of(std::span(entry.fields).first(own), says_it)) continue;
    entry.fields.push_back(field);
    entry.fields.back().is_default = true;
  }
}

}  // namespace

std::vector<Entry> EntryReader::ReadList(const ElementInfo& element, const YamlNode& list) {
  std::vector<Entry> entries;
  if (!IsList(list, fmt::format("{}s", element.name), context_)) return entries;
  for (const YamlNode& item : list.items) {
    if (IsMap(item, fmt::format("a {}'s keys", element.name), context_)) {
      entries.push_back(ReadEntry(element, item));
    }
  }
  return entries;
}

Entry EntryReader::Begin(const ElementInfo& element, const YamlNode& map, const YamlNode& named,
                         Naming naming, std::string_view key) {
  Entry entry;
  entry.element = &element;
  entry.mark = map.mark;
  if (const YamlNode* loops = map.Find("for")) entry.loops = context_.values.ReadLoops(*loops);
  // Reads the name before the local values, because a drawn local value requires a name.
  ReadName(named, key, naming == Naming::kRequired, entry);
  if (const YamlNode* locals = map.Find("let")) {
    ReadLocals(*locals, named.Find(key) != nullptr, entry);
  }
  if (const YamlNode* condition = map.Find("if")) {
    entry.condition = context_.values.ReadCondition(*condition);
  }
  if (entry.condition) {
    entry.condition_uses_locals =
        std::ranges::any_of(entry.condition->inputs(), [&](const expr::Expression::Input& input) {
          return !entry.locals.empty() && input.slot >= entry.locals.front().slot;
        });
  }
  return entry;
}

void EntryReader::End(const Entry& entry) {
  context_.values.EndLoops(entry.loops);
  for (const Local& local : entry.locals) context_.spec.names.Forget(local.name);
}

Entry EntryReader::ReadEntry(const ElementInfo& element, const YamlNode& text) {
  const std::optional<YamlNode> meant = CheckKeys(element, text, context_);
  const YamlNode& map = meant ? *meant : text;
  Entry entry = Begin(element, map, map,
                      map.Find("frame") == nullptr ? Naming::kRequired : Naming::kOptional);
  if (const YamlNode* frame = map.Find("frame"); frame && &element == &kPartElement) {
    ReadFrame(map, *frame, entry);
  } else if (const YamlNode* spec = map.Find("spec"); spec && &element == &kPartElement) {
    ReadWeld(map, *spec, entry);
  } else {
    ReadPlain(element, map, entry);
  }
  End(entry);
  return entry;
}

void EntryReader::ReadLocals(const YamlNode& locals, bool has_name, Entry& entry) {
  if (!IsMap(locals, "values, as in {gap: 1mm .. 3mm}", context_)) return;
  for (const YamlNode::Pair& pair : locals.pairs) {
    if (!context_.values.CheckLocalName("local value", pair)) continue;
    Local local{.name = pair.key, .slot = 0, .value = context_.values.ReadAnything(pair.value)};
    if (HasDraw(local.value) && !has_name) {
      context_.findings.Add(Code::kSpecUnnamedDraw, local.value.mark,
                            fmt::format("'{}' is drawn, so its entry needs a 'name'", local.name),
                            "draws are keyed by names, so moving an entry does not change them");
    }
    if (local.value.is_list) {
      context_.findings.Add(Code::kSpecWrongType, local.value.mark,
                            fmt::format("'{}' is a list; a local value is not", local.name),
                            "make it a parameter, and use its items here");
      local.value = Value{.mark = local.value.mark, .components = 0};
    }
    local.slot = Declare(context_.spec.names, pair.key, local.value).slot;
    context_.locals.emplace_back(pair.key, pair.mark);
    entry.locals.push_back(std::move(local));
  }
}

void EntryReader::ReadName(const YamlNode& map, std::string_view key, bool required, Entry& entry) {
  entry.name.type = expr::Type::kText;
  entry.name.mark = map.mark;
  entry.name.form = Text{};
  const YamlNode* name = map.Find(key);
  if (name == nullptr) {
    if (required) {
      context_.findings.Add(Code::kSpecMissingKey, map.mark,
                            fmt::format("{} without a '{}'", entry.element->name, key));
    }
    return;
  }
  if (name->kind == YamlNode::Kind::kMap) {
    context_.findings.Add(Code::kSpecWrongType, name->mark, "a name cannot be drawn");
    return;
  }
  entry.name = context_.values.ReadText(*name);
  if (const auto literal = LiteralText(entry.name)) {
    CheckName(entry.element->name, *literal, name->mark, context_.findings);
  }
}

void EntryReader::ReadPlain(const ElementInfo& element, const YamlNode& map, Entry& entry) {
  entry.fields = ReadFields(element, map, context_);
  if (const Field* material = entry.Find(Key::kMaterial)) CheckMaterial(material->value);
  const Defaults& defaults = context_.spec.defaults;
  if (&element == &kPartElement) {
    CheckNeeds("params", "spec", map, context_);
    CheckNeeds("materials", "spec", map, context_);
    CheckNeeds("parts", "frame", map, context_);
    AddDefaults(defaults.part, entry);
    CheckPart(entry, context_);
  }
  if (&element == &kSiteElement) AddDefaults(defaults.site, entry);
  if (&element == &kJointElement) {
    AddDefaults(defaults.joint, entry);
    CheckDetent(map, entry, context_);
    ReadCouplings(map, entry, context_);
    ReadTorqueUse(map, entry, context_);
  }
}

void EntryReader::ReadFrame(const YamlNode& map, const YamlNode& frame, Entry& entry) {
  entry.is_frame = true;
  RejectKeys(map, {"name", "if", "for", "let", "frame", "parts"}, kPartElement, "a frame");
  if (IsMap(frame, "a pose", context_)) {
    entry.fields = ReadElementFields(kFrameElement, frame, context_);
  }
  const bool drawn =
      std::ranges::any_of(entry.fields, [](const Field& field) { return HasDraw(field.value); });
  if (drawn && map.Find("name") == nullptr) {
    context_.findings.Add(Code::kSpecUnnamedDraw, map.mark,
                          "a frame whose pose is drawn needs a 'name'",
                          "draws are keyed by names, so moving an entry does not change them");
  }
  const YamlNode* parts = map.Find("parts");
  if (parts == nullptr) {
    context_.findings.Add(Code::kSpecMissingKey, map.mark, "a frame without 'parts'");
  } else {
    entry.children = ReadList(kPartElement, *parts);
  }
}

void EntryReader::ReadWeld(const YamlNode& map, const YamlNode& spec, Entry& entry) {
  RejectKeys(map,
             {"name", "if", "for", "let", "spec", "params", "materials", "pos", "quat", "euler",
              "axisangle", "xyaxes", "zaxis"},
             kPartElement, "a part with 'spec'");
  entry.fields = ReadFields(kFrameElement, map, context_);
  ReadNested(map, spec, entry);
}

void EntryReader::ReadNested(const YamlNode& map, const YamlNode& spec, Entry& entry) {
  const std::string reference = context_.values.ReadPlainText("spec", spec);
  if (!reference.empty()) entry.nested = context_.loader.LoadNested(reference, spec.mark);
  if (entry.nested != nullptr) {
    context_.spec.draws |= entry.nested->draws;
    context_.spec.has_place |= entry.nested->has_place;
  }
  if (const YamlNode* params = map.Find("params");
      params && IsMap(*params, "parameters", context_)) {
    for (const auto& pair : params->pairs) ReadOverride(pair, entry);
  }
  if (const YamlNode* materials = map.Find("materials");
      materials && IsMap(*materials, "names of materials", context_)) {
    for (const auto& pair : materials->pairs) ReadSubstitute(pair, entry);
  }
}

void EntryReader::ReadOverride(const YamlNode::Pair& pair, Entry& entry) {
  const Parameter* parameter =
      entry.nested != nullptr ? entry.nested->FindParameter(pair.key) : nullptr;
  Value value = parameter != nullptr ? context_.values.ReadLike(parameter->value, pair.value)
                                     : context_.values.ReadAnything(pair.value);
  if (entry.nested != nullptr) {
    if (parameter == nullptr) {
      context_.findings.Add(Code::kSpecUnknownParameter, pair.mark,
                            fmt::format("'{}' has no parameter '{}'", entry.nested->name, pair.key),
                            diag::DidYouMean(pair.key, entry.nested->parameters, &Parameter::name));
      return;
    }
    if (value.components == 0) return;
    if (!IsSameKind(parameter->value, value)) {
      context_.findings.Add(
          Code::kSpecWrongType, value.mark,
          fmt::format("parameter '{}' of '{}' is {}, but this is {}", pair.key, entry.nested->name,
                      KindText(parameter->value), KindText(value)));
      return;
    }
    context_.values.CheckUnit(fmt::format("parameter '{}' of '{}'", pair.key, entry.nested->name),
                              parameter->value.dimensions, value);
  }
  entry.overrides.emplace_back(parameter != nullptr ? parameter->name : pair.key, std::move(value));
}

void EntryReader::ReadSubstitute(const YamlNode::Pair& pair, Entry& entry) {
  Value name = context_.values.Read(*kPartElement.Find(Key::kMaterial), pair.value);
  CheckMaterial(name);
  if (entry.nested != nullptr && !HasMaterial(*entry.nested, pair.key)) {
    context_.findings.Add(Code::kSpecUnknownMaterial, pair.mark,
                          fmt::format("'{}' has no material '{}'", entry.nested->name, pair.key),
                          diag::DidYouMean(pair.key, entry.nested->materials, &Material::name));
  }
  entry.substitutes.emplace_back(pair.key, std::move(name));
}

void EntryReader::RejectKeys(const YamlNode& map, std::initializer_list<std::string_view> allowed,
                             const ElementInfo& element, std::string_view what) {
  for (const auto& pair : map.pairs) {
    if (element.Find(pair.key) == nullptr) continue;  // already reported
    if (std::ranges::find(allowed, pair.key) != allowed.end()) continue;
    context_.findings.Add(Code::kSpecConflict, pair.mark,
                          fmt::format("'{}' has no meaning for {}", pair.key, what));
  }
}

void EntryReader::CheckMaterial(const Value& value) {
  const auto name = LiteralText(value);
  if (!name || HasMaterial(context_.spec, *name)) return;
  std::string hint = diag::DidYouMean(*name, context_.spec.materials, &Material::name);
  if (context_.spec.names.Find(*name) != nullptr) {
    hint = fmt::format("to use the parameter's value, write ${{{}}}", *name);
  }
  context_.findings.Add(Code::kSpecUnknownMaterial, value.mark,
                        fmt::format("no material '{}'", *name), std::move(hint));
}

std::vector<Entry> ReadEntries(const ElementInfo& element, const YamlNode* list, Context& context) {
  if (list == nullptr) return {};
  std::vector<Entry> entries = EntryReader(context).ReadList(element, *list);
  std::map<std::string_view, diag::SourceMark> seen;
  CollectSure(element.name, entries, seen, context);
  return entries;
}

std::vector<Entry> ReadRegions(const YamlNode* regions, Context& context) {
  if (regions == nullptr || regions->kind != YamlNode::Kind::kScalar)
    return ReadEntries(kRegionElement, regions, context);
  if (regions->text != "auto") {
    context.findings.Add(
        Code::kSpecBadValue, regions->mark,
        fmt::format("'{}' is neither 'auto' nor a list of regions", regions->text));
    return {};
  }
  YamlNode only = YamlNode::Empty(YamlNode::Kind::kMap, regions->mark);
  for (const auto& [key, text] : {std::pair("name", "surface"), std::pair("type", "auto")})
    only.pairs.push_back({key, regions->mark, YamlNode::Scalar(text, regions->mark)});
  const YamlNode list = YamlNode::List({only}, regions->mark);
  return ReadEntries(kRegionElement, &list, context);
}

std::vector<Entry> ReadViews(const YamlNode& map, Context& context) {
  std::vector<Entry> views = ReadEntries(kCameraElement, map.Find("cameras"), context);
  std::ranges::move(ReadEntries(kLightElement, map.Find("lights"), context),
                    std::back_inserter(views));
  return views;
}

std::optional<bool> IsFreeWord(const YamlNode& joints, Context& context) {
  constexpr std::string_view kWords[] = {"free", "none"};
  if (joints.text == kWords[0] || joints.text == kWords[1]) return joints.text == kWords[0];
  context.findings.Add(
      Code::kSpecBadValue, joints.mark,
      fmt::format("'{}' is neither 'free', 'none' nor a list of joints", joints.text),
      diag::DidYouMean(joints.text, kWords));
  return std::nullopt;
}

void ReadJoints(const YamlNode& joints, Context& context) {
  if (joints.kind == YamlNode::Kind::kScalar) {
    const std::optional<bool> is_free = IsFreeWord(joints, context);
    if (is_free) context.spec.root_joints = *is_free ? RootJoints::kFree : RootJoints::kNone;
    return;
  }
  context.spec.root_joints = RootJoints::kList;
  context.spec.joints = ReadEntries(kJointElement, &joints, context);
}

}  // namespace mjforge::spec
