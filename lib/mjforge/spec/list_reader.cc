// Functions of ValueReader that read lists of numbers, texts or booleans.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/value_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using expr::Type;

bool IsInBrackets(const YamlNode& node) { return node.kind == YamlNode::Kind::kList; }

}  // namespace

bool ValueReader::IsText(const YamlNode& node) const {
  if (node.kind != YamlNode::Kind::kScalar || IsBooleanWord(node)) return false;
  if (node.text.find("${") != std::string::npos) return true;
  if (const auto* variable = LoneName(node)) return variable->type == Type::kText;
  return node.text != "pi" && LooksLikeText(node);
}

bool ValueReader::IsPlainText(const YamlNode& node) const {
  return IsText(node) && LoneName(node) == nullptr && node.text.find("${") == std::string::npos;
}

bool ValueReader::IsBoolean(const YamlNode& node) const {
  if (node.kind != YamlNode::Kind::kScalar) return false;
  if (IsBooleanWord(node)) return true;
  if (const auto* variable = LoneName(node))
    return variable->type == Type::kBoolean && !variable->is_list();
  expr::Error unused;
  const auto expression = expr::Expression::Compile(node.text, names_, unused);
  return expression && expression->type() == Type::kBoolean;
}

// Returns the type of the list's items: kBoolean if any item is a boolean; kText if at least one
// item is a text and all other items are texts or draws; otherwise kNumber.
Type ValueReader::ItemType(const YamlNode& list) const {
  if (std::ranges::any_of(list.items, [this](const auto& item) { return IsBoolean(item); }))
    return Type::kBoolean;
  const auto may_be = [this](const YamlNode& item) {
    return item.kind == YamlNode::Kind::kMap || IsText(item);
  };
  const auto is = [this](const YamlNode& item) { return IsText(item); };
  return std::ranges::all_of(list.items, may_be) && std::ranges::any_of(list.items, is)
             ? Type::kText
             : Type::kNumber;
}

Value ValueReader::ReadItems(Type type, const YamlNode& node) {
  List list;
  for (const YamlNode& item : node.items)
    list.items.push_back(type == Type::kText      ? ReadText(item)
                         : type == Type::kBoolean ? ReadBoolean(item)
                                                  : ReadNumber(item));
  expr::Dimensions dimensions;
  if (type == Type::kNumber) dimensions = Agree("the values of a list", list.items);
  return {.mark = node.mark,
          .type = type,
          .is_list = true,
          .dimensions = std::move(dimensions),
          .form = std::move(list)};
}

Value ValueReader::ReadLike(const Value& wanted, const YamlNode& node,
                            std::span<const std::string_view> extra_keys) {
  if (!wanted.is_list || !IsInBrackets(node)) return ReadAnything(node, extra_keys);
  return ReadItems(node.items.empty() ? wanted.type : ItemType(node), node);
}

std::optional<Value> ValueReader::ReadListOrName(const YamlNode& node) {
  if (IsInBrackets(node)) return ReadItems(ItemType(node), node);
  const auto* variable = LoneName(node);
  if (variable == nullptr || (!variable->is_list() && variable->components == 1))
    return std::nullopt;
  return Reference(*variable, node);
}

std::shared_ptr<const Value> ValueReader::ReadCount(const YamlNode& node) {
  Value count = ReadNumber(node);
  CheckPlain("count", count);
  const auto number = ConstantOf(count);
  if (number && !IsListLength(*number)) {
    findings_.Add(Code::kSpecBadValue, node.mark,
                  fmt::format("count is {}; it {}", expr::NumberText(*number), kListLengthRule));
  }
  return std::make_shared<const Value>(std::move(count));
}

Value ValueReader::ReadListForm(const FieldInfo& expected, const YamlNode& map,
                                const YamlNode::Pair& main) {
  if (expected.kind == FieldKind::kAnything)
    return main.key == "each" ? ReadEach(map) : ReadArrangement(main.key, map);
  findings_.Add(Code::kSpecWrongType, main.mark,
                fmt::format("'{}' makes a list, which has no place here", main.key),
                "a list is a parameter: name it under `params:`");
  return SubstituteFor(map);
}

Value ValueReader::ReadEach(const YamlNode& map) {
  const YamlNode* count = map.Find("count");
  if (count == nullptr) {
    findings_.Add(Code::kSpecMissingKey, map.mark, "'each' without 'count'",
                  "write {each: 1cm .. 2cm, count: 5}");
    return SubstituteFor(map);
  }
  Value item = ReadAnything(*map.Find("each"));
  Value list{.mark = map.mark, .type = item.type, .is_list = true, .dimensions = item.dimensions};
  if (item.components == 0) return SubstituteFor(map);
  if (item.components > 1 || item.is_list) {
    findings_.Add(
        Code::kSpecWrongType, item.mark,
        fmt::format("a list is of numbers, texts or booleans, but this is {}", KindText(item)));
    return SubstituteFor(map);
  }
  list.form = Each{std::make_shared<const Value>(std::move(item)), ReadCount(*count)};
  return list;
}

Value ValueReader::ReadArrangement(std::string_view key, const YamlNode& map) {
  const YamlNode& node = *map.Find(key);
  std::optional<Value> list = ReadListOrName(node);
  if (!list) return Wrong(node, "a list or the name of one");
  const YamlNode* count = map.Find("count");
  if (key == "sample" && count == nullptr) {
    findings_.Add(Code::kSpecMissingKey, map.mark, "'sample' without 'count'",
                  "write {sample: [a, b, c], count: 2}; all of them: {shuffle: [a, b, c]}");
    return SubstituteFor(map);
  }
  draws_.random = true;
  Value value{
      .mark = map.mark, .type = list->type, .is_list = true, .dimensions = list->dimensions};
  value.form = Arrangement{std::make_shared<const Value>(*std::move(list)),
                           count != nullptr ? ReadCount(*count) : nullptr};
  return value;
}

}  // namespace mjforge::spec
