// Counting of structures and parameter values, and search for parameters whose values tell groups
// of structures apart.

#include "mjforge/report/structure_tallies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mjforge/expr/expr.h"
#include "mjforge/report/tallies.h"

namespace mjforge::report {
namespace {

// Largest number of components of a vector that are compared.
constexpr std::size_t kComparedComponents = 8;

void AddValue(std::string value, ParameterExtent& extent) {
  if (extent.more_values) return;
  extent.values.insert(std::move(value));
  extent.more_values = extent.values.size() > ParameterExtent::kMaxValues;
}

void AddNumber(double number, ParameterExtent& extent) {
  extent.low = std::min(extent.low, number);
  extent.high = std::max(extent.high, number);
  if (extent.more_values) return;
  if (number == std::round(number)) {
    AddValue(expr::NumberText(number), extent);
  } else {
    extent.more_values = true;
  }
}

// Returns the extent of the parameter `name`; adds the extent if it is missing. Looks at `position`
// first, and sets `position` to the position after this extent.
ParameterExtent& FindOrAddNext(std::size_t& position, const std::string& name,
                               std::vector<ParameterExtent>& extents) {
  position = FindOrAdd(position, name, extents);
  return extents[position++];
}

void AddParameter(const std::string& name, const sample::ParameterValue& value,
                  std::size_t& position, std::vector<ParameterExtent>& extents) {
  if (const auto text = TextOfWords(value)) {
    AddValue(*text, FindOrAddNext(position, name, extents));
  } else if (const auto* number = std::get_if<double>(&value)) {
    AddNumber(*number, FindOrAddNext(position, name, extents));
  } else {
    const auto& numbers = std::get<std::vector<double>>(value);
    for (std::size_t i = 0; i < std::min(numbers.size(), kComparedComponents); ++i)
      AddNumber(numbers[i], FindOrAddNext(position, fmt::format("{}[{}]", name, i), extents));
  }
}

bool HasCommonValue(const std::vector<const ParameterExtent*>& groups) {
  std::set<std::string> seen;
  for (const ParameterExtent* group : groups) {
    if (group->more_values) return true;
    for (const std::string& value : group->values) {
      if (!seen.insert(value).second) return true;
    }
  }
  return false;
}

bool Overlap(std::vector<const ParameterExtent*> groups) {
  std::ranges::sort(groups, {}, &ParameterExtent::low);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (!(groups[i]->low <= groups[i]->high)) return true;  // a group without numbers
    if (i > 0 && groups[i]->low <= groups[i - 1]->high) return true;
  }
  return false;
}

Separation SeparationOf(const std::vector<const ParameterExtent*>& groups) {
  if (!HasCommonValue(groups)) return Separation::kByValue;
  return Overlap(groups) ? Separation::kNone : Separation::kByRange;
}

// Returns the extent of the parameter `name` in each group; an empty list if any group lacks the
// parameter.
std::vector<const ParameterExtent*> ExtentsOf(
    const std::string& name, const std::map<int, std::vector<ParameterExtent>>& groups) {
  std::vector<const ParameterExtent*> extents;
  for (const auto& [group, params] : groups) {
    const ParameterExtent* found = diag::Find(params, name, &ParameterExtent::name);
    if (found == nullptr) return {};
    extents.push_back(found);
  }
  return extents;
}

void AppendAll(const std::vector<ParameterExtent>& from, std::vector<ParameterExtent>& to) {
  std::size_t position = 0;
  for (const ParameterExtent& extent : from)
    FindOrAddNext(position, extent.name, to).Append(extent);
}

}  // namespace

void ParameterExtent::Append(const ParameterExtent& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
  more_values = more_values || other.more_values;
  for (const std::string& value : other.values) AddValue(value, *this);
}

void StructureTally::Add(const manifest::Record& record) {
  if (variants++ == 0) first = record;
  std::size_t position = 0;
  for (const auto& [name, value] : record.params) AddParameter(name, value, position, params);
}

void StructureTally::Append(const StructureTally& next) {
  if (variants == 0) first = next.first;
  variants += next.variants;
  AppendAll(next.params, params);
}

// Returns the tally of a structure; adds the tally if it is missing. Returns null if it is missing
// and there are kMaxStructures others.
StructureTally* StructureTallies::FindOrAdd(const std::string& key) {
  const auto [known, is_new] = numbers_.try_emplace(key, list_.size());
  if (!is_new) return &list_[known->second];
  if (list_.size() == kMaxStructures) {
    numbers_.erase(known);
    return nullptr;
  }
  StructureTally& added = list_.emplace_back();
  added.key = key;
  return &added;
}

void StructureTallies::Add(const manifest::Record& record) {
  if (record.structure.empty()) return;
  if (StructureTally* tally = FindOrAdd(record.structure)) {
    tally->Add(record);
  } else {
    ++more_;
  }
}

void StructureTallies::Append(const StructureTallies& next) {
  more_ += next.more_;
  for (const StructureTally& tally : next.list_) {
    if (StructureTally* known = FindOrAdd(tally.key)) {
      known->Append(tally);
    } else {
      more_ += tally.variants;
    }
  }
}

std::vector<Separator> SeparatorsOf(const std::vector<StructureTally>& structures,
                                    const std::vector<int>& groups) {
  std::map<int, std::vector<ParameterExtent>> merged;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    if (groups[i] >= 0) AppendAll(structures[i].params, merged[groups[i]]);
  }
  std::vector<Separator> by_value;
  std::vector<Separator> by_range;
  if (merged.size() < 2) return by_value;
  for (const ParameterExtent& param : merged.begin()->second) {
    const auto extents = ExtentsOf(param.name, merged);
    if (extents.empty()) continue;
    const Separation separation = SeparationOf(extents);
    if (separation == Separation::kByValue) by_value.push_back({param.name, separation});
    if (separation == Separation::kByRange) by_range.push_back({param.name, separation});
  }
  return by_value.empty() ? by_range : by_value;
}

}  // namespace mjforge::report
