// Operations on lists: search by a key, conversion of all items, joining of texts.

#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mjforge::diag {

/// Returns the first item of the list that meets a condition; null if there is none.
template <std::ranges::borrowed_range List, typename Condition>
auto* FindIf(List&& list, Condition condition) {
  const auto found = std::ranges::find_if(list, std::move(condition));
  return found == std::ranges::end(list) ? nullptr : &*found;
}

/// Returns the first item of the list whose key equals `key`; null if there is none. `key_of` is a
/// projection (a pointer to a member, for example) from an item of the list to its key.
template <std::ranges::borrowed_range List, typename Key, typename KeyOf>
auto* Find(List&& list, const Key& key, KeyOf key_of) {
  return FindIf(list, [&](const auto& item) { return std::invoke(key_of, item) == key; });
}

/// Returns the values that `value_of`, a projection, gives for the items of a list.
template <typename Value, typename List, typename ValueOf>
std::vector<Value> Mapped(const List& list, const ValueOf& value_of) {
  std::vector<Value> values;
  values.reserve(std::ranges::size(list));
  for (const auto& item : list) values.push_back(std::invoke(value_of, item));
  return values;
}

/// Returns the texts of a list with the separator between them. `text_of` is a projection from an
/// item of the list to its text.
template <typename List, typename TextOf>
std::string Joined(const List& list, std::string_view separator, const TextOf& text_of) {
  std::string joined;
  for (bool is_first = true; const auto& item : list) {
    if (!std::exchange(is_first, false)) joined += separator;
    joined += std::invoke(text_of, item);
  }
  return joined;
}

}  // namespace mjforge::diag
