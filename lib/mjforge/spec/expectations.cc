// Reader of `expect:`, the conditions that every variant must meet.

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Keys for the kinds of expectations, in the order of ExpectationKind.
constexpr std::array kKinds = {Key::kThat, Key::kGap, Key::kTouch, Key::kApart, Key::kInside};

class ExpectationReader {
 public:
  explicit ExpectationReader(Context& context) : context_(context), entries_(context) {}

  void Read(const YamlNode& list) {
    if (!IsList(list, "conditions and expectations", context_)) return;
    for (const YamlNode& item : list.items) {
      if (item.kind == YamlNode::Kind::kScalar) {
        Expectation expectation;
        expectation.entry.mark = item.mark;
        expectation.condition = context_.values.ReadCondition(item);
        if (expectation.condition) context_.spec.expectations.push_back(std::move(expectation));
      } else if (IsMap(item, "an expectation's keys", context_)) {
        ReadOne(item);
      }
    }
  }

 private:
  void ReadOne(const YamlNode& text) {
    const std::optional<YamlNode> meant = CheckKeys(kExpectationElement, text, context_);
    const YamlNode& map = meant ? *meant : text;
    Expectation expectation;
    expectation.entry = entries_.Begin(kExpectationElement, map, map);
    if (const YamlNode* doc = map.Find("doc"))
      expectation.doc = context_.values.ReadPlainText("doc", *doc);
    const YamlNode::Pair* what = KindOf(map, expectation.kind);
    expectation.entry.fields = ReadFields(kExpectationElement, map, context_);
    CheckFields(map, expectation);
    if (const YamlNode* at = map.Find("at")) expectation.at = ReadPositions(*at, context_);
    RejectDraws(expectation);
    if (what != nullptr && expectation.kind == ExpectationKind::kThat)
      expectation.condition = context_.values.ReadCondition(what->value);
    const bool is_read = what != nullptr && (expectation.kind == ExpectationKind::kThat
                                                 ? expectation.condition.has_value()
                                                 : ReadNames(*what, expectation));
    entries_.End(expectation.entry);
    if (is_read) context_.spec.expectations.push_back(std::move(expectation));
  }

  // Returns the pair whose key is in kKinds, and sets `kind`. Returns null, after adding a finding,
  // unless the mapping has exactly one such pair.
  const YamlNode::Pair* KindOf(const YamlNode& map, ExpectationKind& kind) {
    const YamlNode::Pair* only = nullptr;
    for (const YamlNode::Pair& pair : map.pairs) {
      const FieldInfo* field = kExpectationElement.Find(pair.key);
      const auto found = std::ranges::find(kKinds, field != nullptr ? field->id : Key::kAttribute);
      if (found == kKinds.end()) continue;
      if (only != nullptr) {
        context_.findings.Add(Code::kSpecConflict, pair.mark,
                              fmt::format("'{}' together with '{}': an entry expects one thing",
                                          pair.key, only->key));
        return nullptr;
      }
      only = &pair;
      kind = static_cast<ExpectationKind>(found - kKinds.begin());
    }
    if (only == nullptr) {
      context_.findings.Add(Code::kSpecMissingKey, map.mark,
                            "nothing is expected here: 'that', 'gap', 'touch', 'apart' or 'inside' "
                            "is missing");
    }
    return only;
  }

  bool ReadNames(const YamlNode::Pair& pair, Expectation& expectation) {
    if (pair.value.kind != YamlNode::Kind::kList || pair.value.items.size() != 2) {
      context_.findings.Add(
          Code::kSpecWrongLength, pair.value.mark,
          fmt::format("expected the names of two bodies or parts: {}: [NAME, NAME]", pair.key));
      return false;
    }
    for (const YamlNode& name : pair.value.items)
      expectation.names.push_back(context_.values.ReadText(name));
    return true;
  }

  void CheckFields(const YamlNode& map, const Expectation& expectation) {
    const bool is_gap = expectation.kind == ExpectationKind::kGap;
    for (const Field& field : expectation.entry.fields) {
      if (is_gap) break;
      context_.findings.Add(Code::kSpecConflict, field.mark,
                            fmt::format("'{}' only has a meaning beside 'gap'", field.info->key));
    }
    if (is_gap && expectation.entry.fields.empty())
      context_.findings.Add(Code::kSpecMissingKey, map.mark, "'gap' without 'min' or 'max'",
                            "write {gap: [a, b], min: 0.2mm}");
    CheckGap(expectation.entry);
    const YamlNode::Pair* at = map.FindPair("at");
    if (at != nullptr && expectation.kind == ExpectationKind::kThat)
      context_.findings.Add(Code::kSpecConflict, at->mark,
                            "'at' has no meaning for a condition, which is on the object at rest");
  }

  void CheckGap(const Entry& entry) {
    const Field* min = entry.Find(Key::kMin);
    const Field* max = entry.Find(Key::kMax);
    if (min == nullptr || max == nullptr) return;
    const double low = ConstantOf(min->value).value_or(-kInfinity);
    const double high = ConstantOf(max->value).value_or(kInfinity);
    if (low <= high) return;
    context_.findings.Add(Code::kSpecEmptyRange, max->mark,
                          fmt::format("no gap is at least {} and at most {}", expr::NumberText(low),
                                      expr::NumberText(high)),
                          "swap the two");
  }

  void RejectDraws(const Expectation& expectation) {
    const auto reject = [&](const Value& value) {
      if (HasDraw(value))
        context_.findings.Add(Code::kSpecConflict, value.mark, "what is expected cannot be drawn",
                              "draw it as a parameter and use that parameter's name");
    };
    for (const Field& field : expectation.entry.fields) reject(field.value);
    for (const JointPosition& position : expectation.at) reject(position.value);
  }

  Context& context_;
  EntryReader entries_;
};

}  // namespace

void ReadExpectations(const YamlNode& list, Context& context) {
  ObjectSpec& spec = context.spec;
  const auto declare = [&](const std::string& name, Key key, int components) {
    if (spec.names.Find(name) != nullptr) return -1;
    auto unit = DimensionsOf(kObjectElement.Find(key)->unit);
    return spec.names.Declare(name, expr::Type::kNumber, components, *std::move(unit)).slot;
  };
  spec.mass_slot = declare("mass", Key::kMass, 1);
  spec.bounds_slot = declare("bounds", Key::kTotalSize, 3);
  ExpectationReader(context).Read(list);
  if (spec.mass_slot >= 0) spec.names.Forget("mass");
  if (spec.bounds_slot >= 0) spec.names.Forget("bounds");
}

}  // namespace mjforge::spec
