// Functions for elements of all kinds: checks of keys, fields with values, search for fields.

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Groups of keys that define the same property. An element may have only one key of a group.
constexpr Key kOrientations[] = {Key::kQuat,   Key::kEuler, Key::kAxisAngle,
                                 Key::kXyAxes, Key::kZAxis, Key::kFromTo};
constexpr Key kMasses[] = {Key::kDensity, Key::kMass};
constexpr Key kPlaces[] = {Key::kPos, Key::kFromTo};
constexpr Key kRatios[] = {Key::kRatio, Key::kLead, Key::kPolycoef};
constexpr Key kPictures[] = {Key::kBuiltin, Key::kFile};

struct ExclusiveKeys {
  std::string_view what;
  std::span<const Key> keys;
};
constexpr ExclusiveKeys kExclusiveKeys[] = {{"an orientation", kOrientations},
                                            {"a mass", kMasses},
                                            {"a place", kPlaces},
                                            {"a ratio", kRatios},
                                            {"a texture", kPictures}};

bool Has(const ExclusiveKeys& group, Key key) {
  return std::ranges::find(group.keys, key) != group.keys.end();
}

// Returns the indefinite article for the name of an element: "a " or "an "; an empty text for a
// plural.
std::string_view Article(std::string_view name) {
  if (name == "checks" || name == "defaults" || name == "holds") return "";
  return std::string_view("aeiou").find(name[0]) != std::string_view::npos ? "an " : "a ";
}

// Returns "'joints' is a key of a body" for a key of another element; otherwise an empty text.
std::string OwnerOf(std::string_view key, const ElementInfo& element) {
  if (&element == &kPlaceElement && kBesideElement.Find(key) != nullptr)
    return fmt::format("'{}' is a key of `beside:`", key);
  for (const ElementInfo* owner :
       {&kBodyElement, &kPartElement, &kObjectElement, &kJointElement, &kPlaceElement}) {
    if (owner->Find(key) != nullptr)
      return fmt::format("'{}' is a key of {}{}", key, Article(owner->name), owner->name);
  }
  return {};
}

// Meaning of a key that an element does not have.
struct Meaning {
  std::string_view key;  // key that was probably meant, and is missing; empty: unknown
  std::string hint;
};

Meaning MeaningOf(std::string_view key, const ElementInfo& element, const YamlNode& map) {
  if (key == "<<") return {{}, "YAML 1.2 has no merge keys; use `defaults:`"};
  if (&element == &kPlaceElement && key == "on")
    return {map.Find("at") == nullptr ? "at" : "", "write `at`; YAML 1.1 reads `on` as true"};
  if (std::string owner = OwnerOf(key, element); !owner.empty()) return {{}, std::move(owner)};
  std::vector<std::string_view> missing;
  for (const FieldInfo& field : element.fields) {
    if (map.Find(field.key) == nullptr) missing.push_back(field.key);
  }
  if (const auto closest = diag::ClosestWord(key, missing))
    return {*closest, fmt::format("did you mean '{}'?", *closest)};
  return {{}, diag::DidYouMean(key, element.fields, &FieldInfo::key)};
}

void CheckOneOf(const ExclusiveKeys& group, const std::vector<Field>& fields, Context& context) {
  const Field* first = nullptr;
  for (const Field& field : fields) {
    if (!Has(group, field.info->id)) continue;
    if (first != nullptr) {
      context.findings
          .Add(Code::kSpecConflict, field.mark,
               fmt::format("'{}' together with '{}': {} is given in only one way", field.info->key,
                           first->info->key, group.what))
          .notes.push_back({first->mark, "first here"});
    } else {
      first = &field;
    }
  }
}

// Returns the motion of a joint: kSlide for a slide joint, kTurn for a hinge or ball joint; a joint
// without a type is a hinge. Returns kAny for a free joint, for a type that is not a literal (drawn
// or computed), and for other elements.
Motion MotionOf(const ElementInfo& element, const YamlNode& map, const Context& context) {
  if (&element != &kJointElement) return Motion::kAny;
  const YamlNode* own = map.Find("type");
  const Field* fallback = FindField(context.spec.defaults.joint, Key::kType);
  const std::string_view type = own != nullptr ? std::string_view(own->text) : JointType(fallback);
  if (type == "slide") return Motion::kSlide;
  return type == "hinge" || type == "ball" ? Motion::kTurn : Motion::kAny;
}

}  // namespace

std::string_view JointType(const Field* type) {
  return type == nullptr ? "hinge" : LiteralText(type->value).value_or("");
}

const Field* FindField(std::span<const Field> fields, Key id) {
  return diag::FindIf(fields, [id](const Field& field) { return field.info->id == id; });
}

const Field* Entry::Find(Key id) const { return FindField(fields, id); }
const Entry* Entry::FindChild(const ElementInfo& kind) const {
  return diag::Find(children, &kind, &Entry::element);
}
const Field* PlaceEntry::Find(Key id) const { return FindField(fields, id); }
const Field* PlaceEntry::FindBeside(Key id) const { return FindField(beside, id); }
const Field* Material::Find(Key id) const { return FindField(fields, id); }

const Value& ObjectSpec::ValueOf(const Parameter& parameter) const {
  const auto* in_file = std::get_if<SharedParameter>(&parameter.value.form);
  if (in_file == nullptr) return parameter.value;
  const ObjectSpec& file = *shared[in_file->file];
  return file.ValueOf(file.parameters[in_file->position]);
}

const Parameter* ObjectSpec::FindParameter(std::string_view parameter) const {
  return diag::FindIf(parameters, [&](const Parameter& one) {
    return one.name == parameter || (!one.record.empty() && one.record == parameter);
  });
}

std::optional<YamlNode> CheckKeys(const ElementInfo& element, const YamlNode& map,
                                  Context& context) {
  std::optional<YamlNode> meant;
  for (std::size_t i = 0; i < map.pairs.size(); ++i) {
    const YamlNode::Pair& pair = map.pairs[i];
    if (element.Find(pair.key) != nullptr) continue;
    if (!meant) meant = map;
    auto [key, hint] = MeaningOf(pair.key, element, *meant);
    if (!key.empty()) meant->pairs[i].key = key;
    context.findings.Add(
        Code::kSpecUnknownKey, pair.mark,
        fmt::format("unknown key '{}' in {}{}", pair.key, Article(element.name), element.name),
        std::move(hint));
  }
  return meant;
}

bool IsMap(const YamlNode& node, std::string_view what, Context& context) {
  if (node.kind == YamlNode::Kind::kMap) return true;
  context.findings.Add(Code::kSpecWrongType, node.mark,
                       fmt::format("expected a mapping with {}, got {}", what, KindName(node)));
  return false;
}

bool IsList(const YamlNode& node, std::string_view what, Context& context) {
  if (node.kind == YamlNode::Kind::kList) return true;
  context.findings.Add(Code::kSpecWrongType, node.mark,
                       fmt::format("expected a list of {}, got {}", what, KindName(node)));
  return false;
}

std::span<const YamlNode> OneOrMore(const YamlNode& node, std::string_view what, Context& context) {
  if (node.kind == YamlNode::Kind::kScalar) return {&node, 1};
  return IsList(node, what, context) ? node.items : std::span<const YamlNode>();
}

std::vector<Field> ReadFields(const ElementInfo& element, const YamlNode& map, Context& context) {
  std::vector<Field> fields;
  const Motion motion = MotionOf(element, map, context);
  for (const auto& pair : map.pairs) {
    const FieldInfo* info = element.Find(pair.key);
    if (info == nullptr || !HoldsValue(info->kind) || info->id == Key::kName) continue;
    fields.emplace_back(info, context.values.Read(*info, pair.value, motion), pair.mark);
  }
  for (const ExclusiveKeys& group : kExclusiveKeys) CheckOneOf(group, fields, context);
  return fields;
}

void CheckNeeds(std::string_view key, std::string_view other, const YamlNode& map,
                Context& context) {
  const YamlNode::Pair* pair = map.FindPair(key);
  if (pair == nullptr || map.Find(other) != nullptr) return;
  context.findings.Add(Code::kSpecConflict, pair->mark,
                       fmt::format("'{}' needs '{}' in the same entry", key, other));
}

void RejectBeside(std::string_view key, std::span<const std::string_view> keys, const YamlNode& map,
                  std::string_view reason, Context& context) {
  for (const YamlNode::Pair& pair : map.pairs) {
    if (std::ranges::find(keys, pair.key) == keys.end()) continue;
    context.findings
        .Add(Code::kSpecConflict, pair.mark,
             fmt::format("'{}' together with '{}': {}", pair.key, key, reason))
        .notes.push_back({map.FindPair(key)->mark, fmt::format("'{}' is here", key)});
  }
}

std::vector<Field> ReadElementFields(const ElementInfo& element, const YamlNode& text,
                                     Context& context) {
  const std::optional<YamlNode> meant = CheckKeys(element, text, context);
  const YamlNode& map = meant ? *meant : text;
  for (const FieldInfo& field : element.fields) {
    if (!field.required || map.Find(field.key) != nullptr) continue;
    context.findings.Add(Code::kSpecMissingKey, map.mark,
                         fmt::format("'{}' without '{}'", element.name, field.key),
                         std::string(field.doc));
  }
  return ReadFields(element, map, context);
}

Entry* ReadChild(const ElementInfo& element, const YamlNode& map, Entry& entry, Context& context) {
  const YamlNode::Pair* pair = map.FindPair(element.name);
  if (pair == nullptr ||
      !IsMap(pair->value, fmt::format("the keys of '{}'", element.name), context))
    return nullptr;
  Entry& child = entry.children.emplace_back();
  child.element = &element;
  child.mark = pair->mark;
  child.fields = ReadElementFields(element, pair->value, context);
  return &child;
}

bool ExcludeEachOther(const FieldInfo& a, const FieldInfo& b) {
  return &a == &b || std::ranges::any_of(kExclusiveKeys, [&](const ExclusiveKeys& group) {
    return Has(group, a.id) && Has(group, b.id);
  });
}

void CheckName(std::string_view what, std::string_view name, diag::SourceMark mark,
               diag::Findings& findings) {
  if (expr::IsName(name)) return;
  findings.Add(Code::kSpecBadName, mark,
               fmt::format("{} name '{}' is not a valid name", what, name),
               "a letter, then letters, digits and underscores");
}

}  // namespace mjforge::spec
