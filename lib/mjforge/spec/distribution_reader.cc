// Functions of ValueReader that read distributions, and the vector forms `about`, `on_sphere` and
// `hsv`.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "mjforge/spec/field_kinds.h"
#include "mjforge/spec/value_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using expr::Type;

constexpr std::string_view kAbout = "about";
constexpr std::string_view kOnSphere = "on_sphere";
constexpr std::string_view kHsv = "hsv";
constexpr std::string_view kExact = "exact";
constexpr std::string_view kEach = "each";
constexpr std::string_view kShuffle = "shuffle";
constexpr std::string_view kSample = "sample";
constexpr std::string_view kCount = "count";

bool IsListForm(std::string_view key) { return key == kEach || key == kShuffle || key == kSample; }

const DistributionInfo* FindDistribution(std::string_view key) {
  return diag::Find(Distributions(), key, &DistributionInfo::key);
}

// Returns true if values of this kind can be drawn from the distribution.
bool Fits(const DistributionInfo& info, FieldKind kind) {
  if (info.arguments < 0 || kind == FieldKind::kAnything) return true;
  if (info.id == Distribution::kBernoulli) return kind == FieldKind::kBoolean;
  return kind == FieldKind::kNumber || kind == FieldKind::kInteger || kind == FieldKind::kNumbers;
}

// Returns true if `key` is an option of the kind of draw that the key `main` names: `clip` beside
// `normal`, `count` beside `each`.
bool IsOption(std::string_view key, std::string_view main) {
  if (const DistributionInfo* info = FindDistribution(main))
    return !key.empty() && (key == info->option || key == info->flag);
  return key == kCount && (main == kEach || main == kSample);
}

std::vector<std::string_view> KnownKeys(std::span<const std::string_view> extra_keys,
                                        const DistributionInfo* main) {
  std::vector<std::string_view> keys(extra_keys.begin(), extra_keys.end());
  if (main != nullptr) {
    for (const std::string_view key : {main->option, main->flag}) {
      if (!key.empty()) keys.push_back(key);
    }
  }
  for (const DistributionInfo& info : Distributions()) keys.push_back(info.key);
  for (const std::string_view key : {kAbout, kOnSphere, kHsv, kEach, kShuffle, kSample})
    keys.push_back(key);
  return keys;
}

// Returns true if a field accepts the vector form `key`: a rotation or a colour, which have four
// numbers, or a point on a sphere.
bool TakesVectorForm(const FieldInfo& expected, std::string_view key) {
  const int count = key == kOnSphere ? 3 : 4;
  return expected.kind == FieldKind::kAnything ||
         (expected.kind == FieldKind::kNumbers && expected.min_count <= count &&
          count <= expected.max_count);
}

std::string KnownDistributions() {
  return "the distributions are " + diag::Joined(Distributions(), ", ", &DistributionInfo::key);
}

}  // namespace

bool IsDrawKey(std::string_view key) {
  return FindDistribution(key) != nullptr || IsListForm(key) || key == kAbout || key == kOnSphere ||
         key == kHsv;
}

// Reports the form `hsv` (a colour) in a field other than `rgba`, and the form `about` (a random
// rotation) in a field that is not a quaternion. Values of parameters, which have no key, accept
// both forms.
void ValueReader::CheckMeaning(bool is_color, const FieldInfo& expected, const YamlNode& node) {
  const std::string_view key = expected.key;
  if (key.empty() || (is_color ? key == "rgba" : key.ends_with("quat"))) return;
  findings_.Add(Code::kSpecWrongType, node.mark,
                fmt::format("'{}' is not a {}", key, is_color ? "colour" : "quaternion"),
                is_color ? "'hsv' makes red, green, blue and opacity, as for 'rgba'"
                         : "a random rotation is a quaternion, as for 'quat'");
}

Value ValueReader::ReadVectorForm(std::string_view key, const FieldInfo& expected,
                                  const YamlNode& node) {
  Value value{.mark = node.mark,
              .components = key == kOnSphere ? 3 : 4,
              .dimensions = {expr::Dimension::Count()}};
  if (!TakesVectorForm(expected, key)) {
    findings_.Add(
        Code::kSpecWrongType, node.mark,
        fmt::format("'{}' draws {} numbers, but {} {} expected here", key, value.components,
                    expected.kind == FieldKind::kNumbers ? fmt::format("{}", expected.max_count)
                                                         : std::string(InfoOf(expected.kind).drawn),
                    expected.max_count == 1 ? "is" : "are"));
    return value;
  }
  draws_.random |= key != kHsv;  // a colour is random only if its items are
  if (key != kOnSphere) CheckMeaning(key == kHsv, expected, node);
  if (key == kAbout) {
    value.form = RotationAbout{std::make_shared<const Value>(
        ReadVector({.kind = FieldKind::kNumbers, .min_count = 3, .max_count = 3}, node))};
  } else if (key == kOnSphere) {
    Value radius = ReadNumber(node);
    value.dimensions = radius.dimensions;
    value.form = PointOnSphere{std::make_shared<const Value>(std::move(radius))};
  } else {
    Value items = ReadVector({.kind = FieldKind::kNumbers, .min_count = 3, .max_count = 4}, node);
    auto* list = std::get_if<List>(&items.form);
    if (list == nullptr) return Wrong(node, "a list [hue, saturation, value]");
    value.form = HsvColor{std::move(list->items)};
  }
  return value;
}

// Reports the unknown key `pair` of a draw's mapping. `lost` is true if the mapping contains no key
// of a draw at all.
void ValueReader::ReportUnknownKey(const YamlNode::Pair& pair,
                                   const std::vector<std::string_view>& known, bool lost) {
  if (pair.key == "for" || pair.key == "if") {
    findings_.Add(Code::kSpecUnknownKey, pair.mark,
                  fmt::format("'{}' has no meaning within a value", pair.key),
                  "it belongs to an entry of a list such as `parts:`; write out all numbers or "
                  "points");
    return;
  }
  std::string hint = pair.key == kExact ? "'exact' is only allowed with 'choice'"
                                        : diag::DidYouMean(pair.key, known);
  const bool is_sentence = pair.key.find(' ') != pair.key.npos;
  if (is_sentence) hint = "a comma ends a value in braces: quote a text that has one";
  if (hint.empty() && lost) hint = KnownDistributions();
  findings_.Add(Code::kSpecUnknownKey, pair.mark,
                fmt::format("unknown key '{}' in a distribution", pair.key), std::move(hint));
}

Value ValueReader::ReadMapping(const FieldInfo& expected, const YamlNode& node,
                               std::span<const std::string_view> extra_keys) {
  const YamlNode::Pair* main = nullptr;
  for (const auto& pair : node.pairs) {
    if (!IsDrawKey(pair.key) && (pair.key != "value" || extra_keys.empty())) continue;
    if (main != nullptr) {
      findings_.Add(Code::kSpecConflict, pair.mark,
                    fmt::format("'{}' together with '{}': a value is drawn in only one way",
                                pair.key, main->key));
      return SubstituteFor(node);
    }
    main = &pair;
  }
  const DistributionInfo* distribution = main != nullptr ? FindDistribution(main->key) : nullptr;
  for (const auto& pair : node.pairs) {
    const bool beside = main != nullptr && IsOption(pair.key, main->key);
    if (&pair == main || beside || std::ranges::find(extra_keys, pair.key) != extra_keys.end()) {
      continue;
    }
    const std::vector<std::string_view> known = KnownKeys(extra_keys, distribution);
    ReportUnknownKey(pair, known, main == nullptr);
    if (main != nullptr) continue;
    const auto closest = diag::ClosestWord(pair.key, known);
    if (!closest || node.Find(*closest) != nullptr) return SubstituteFor(node);
    YamlNode meant = node;
    std::ranges::find(meant.pairs, pair.key, &YamlNode::Pair::key)->key = *closest;
    return ReadMapping(expected, meant, extra_keys);
  }
  if (main == nullptr)
    return Wrong(
        node, extra_keys.empty() ? InfoOf(expected.kind).drawn : "a key 'value' or a distribution");
  if (main->key == "value") return ReadAnything(main->value);
  if (distribution != nullptr) return ReadDraw(*distribution, expected, node);
  if (IsListForm(main->key)) return ReadListForm(expected, node, *main);
  return ReadVectorForm(main->key, expected, main->value);
}

Value ValueReader::ReadDraw(const DistributionInfo& info, const FieldInfo& expected,
                            const YamlNode& map) {
  const YamlNode& node = *map.Find(info.key);
  Value value = SubstituteFor(map);
  if (!Fits(info, expected.kind)) {
    findings_.Add(
        Code::kSpecWrongType, map.mark,
        fmt::format("expected {}, but '{}' draws {}", InfoOf(expected.kind).drawn, info.key,
                    info.id == Distribution::kBernoulli ? "true or false" : "numbers"));
    return value;
  }
  Draw draw;
  draw.distribution = info.id;
  draws_.random |= info.id != Distribution::kCycle;
  if (info.arguments < 0) {
    ReadOptions(expected, node, draw, value);
  } else {
    if (!ReadArguments(info, node, draw)) return value;
    value.components = 1;
    if (info.id == Distribution::kBernoulli) value.type = Type::kBoolean;
  }
  if (const YamlNode* option = info.option.empty() ? nullptr : map.Find(info.option)) {
    ReadDrawOption(info, *option, draw);
  }
  if (const YamlNode* flag = info.flag.empty() ? nullptr : map.Find(info.flag)) {
    ReadExact(*flag, draw);
  }
  if (value.type == Type::kNumber) value.dimensions = DimensionsOfDraw(info, expected, draw);
  value.form = std::move(draw);
  return value;
}

bool ValueReader::ReadArguments(const DistributionInfo& info, const YamlNode& node, Draw& draw) {
  const bool single = info.arguments == 1 && node.kind != YamlNode::Kind::kList;
  const std::size_t count = single ? 1 : node.items.size();
  const auto wanted = static_cast<std::size_t>(info.arguments);
  if (count != wanted) {
    findings_.Add(Code::kSpecDistribution, node.mark,
                  fmt::format("'{}' takes {}", info.key, diag::Counted(wanted, "number")),
                  fmt::format("write {}", info.usage));
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    draw.arguments.push_back(ReadNumber(single ? node : node.items[i]));
  }
  if (info.id == Distribution::kUniform || info.id == Distribution::kInteger ||
      info.id == Distribution::kLogUniform) {
    CheckRangeOrder(draw.arguments[0], draw.arguments[1], node.mark);
  }
  return true;
}

void ValueReader::ReadDrawOption(const DistributionInfo& info, const YamlNode& node, Draw& draw) {
  if (node.kind != YamlNode::Kind::kList) {
    Wrong(node, fmt::format("a list for '{}'", info.option));
    return;
  }
  const bool weights = info.option == "weights";
  const std::size_t wanted = weights ? draw.arguments.size() : 2;
  if (node.items.size() != wanted) {
    findings_.Add(
        Code::kSpecWrongLength, node.mark,
        fmt::format("'{}' has {} numbers; it needs {}", info.option, node.items.size(), wanted),
        weights ? "one weight for each value" : "");
    return;
  }
  for (const YamlNode& item : node.items) {
    (weights ? draw.weights : draw.limits).push_back(ReadNumber(item));
  }
  if (!weights) CheckRangeOrder(draw.limits[0], draw.limits[1], node.mark);
}

// Reads `exact`. The weights must be constants, because the counts of the options over a batch are
// computed before anything is drawn.
void ValueReader::ReadExact(const YamlNode& node, Draw& draw) {
  if (!IsBooleanWord(node)) {
    Wrong(node, "true or false");
    return;
  }
  draw.exact = node.text == "true";
  if (!draw.exact) return;
  draws_.exact = true;
  for (const Value& weight : draw.weights) {
    if (weight.components == 0 || ConstantOf(weight)) continue;  // 0: already reported
    findings_.Add(Code::kSpecNotConstant, weight.mark,
                  "the weights of an exact choice must be constants",
                  "without `exact: true` they may be computed and drawn");
  }
}

void ValueReader::ReadOptions(const FieldInfo& expected, const YamlNode& list, Draw& draw,
                              Value& value) {
  if (list.kind != YamlNode::Kind::kList || list.items.empty()) {
    if (list.kind == YamlNode::Kind::kList)
      findings_.Add(Code::kSpecWrongLength, list.mark,
                    "the list of values to choose from is empty");
    else
      Wrong(list, "a list of values to choose from");
    draw.arguments.push_back(SubstituteFor(list));
    return;
  }
  const auto is_list = [this](const YamlNode& item) {
    return item.kind == YamlNode::Kind::kList &&
           (item.items.size() > 4 || ItemType(item) != Type::kNumber);
  };
  // Reads all options as lists if any option is a list. Short lists would otherwise be read as
  // vectors.
  Value kind;
  kind.is_list = expected.kind == FieldKind::kAnything && std::ranges::any_of(list.items, is_list);
  for (const YamlNode& item : list.items)
    draw.arguments.push_back(kind.is_list ? ReadLike(kind, item) : ReadForm(expected, item));
  const Value& first = draw.arguments.front();
  value.type = first.type;
  value.components = first.components;
  value.is_list = first.is_list;
  for (const Value& option : draw.arguments) {
    if (option.components == 0 || first.components == 0) return;
    const bool any_count =
        expected.kind == FieldKind::kNumbers && expected.max_count > expected.min_count;
    if (IsSameKind(option, first) || (any_count && option.type == first.type)) continue;
    findings_.Add(Code::kSpecWrongType, option.mark,
                  fmt::format("the values to choose from are of different kinds: {} and {}",
                              KindText(first), KindText(option)));
    return;
  }
}

}  // namespace mjforge::spec
