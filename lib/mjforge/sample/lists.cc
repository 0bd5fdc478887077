// Functions of Evaluator that evaluate lists (literal, repeated, shuffled, sampled).

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {

using expr::Type;

std::optional<Items> Evaluator::List(const spec::Value& value, StreamId path) {
  if (const auto* variable = std::get_if<spec::VariableReference>(&value.form))
    return CopyList(*variable, value);
  if (const auto* each = std::get_if<spec::Each>(&value.form)) return Repeat(*each, path);
  if (const auto* arrangement = std::get_if<spec::Arrangement>(&value.form))
    return Arrange(*arrangement, path);
  if (const spec::Draw* choice = ChoiceOf(value)) {
    const spec::Value* chosen = Choose(*choice, value.mark, path);
    return chosen != nullptr ? List(*chosen, path) : std::nullopt;
  }
  std::optional<Items> items(std::in_place);
  const auto* list = std::get_if<spec::List>(&value.form);
  bool is_good = true;
  for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i) {
    const spec::Value& item = list->items[i];
    is_good &= AppendItem(item, value.type, ItemStream(item, path, i), *items);
  }
  if (!is_good) items.reset();
  return items;
}

bool Evaluator::AppendItem(const spec::Value& item, Type type, StreamId path, Items& out) {
  if (type != Type::kText) {
    out.numbers.push_back(Number(item, path));
    return !std::isnan(out.numbers.back());
  }
  std::optional<std::string> text = Text(item, path);
  if (!text) return false;
  out.numbers.push_back(expr::TextKey(*text));
  out.texts.push_back(*std::move(text));
  return true;
}

// Returns the items of a list parameter, or the components of a vector parameter as items.
std::optional<Items> Evaluator::CopyList(const spec::VariableReference& variable,
                                         const spec::Value& value) {
  Items items;
  const int components = variable.list < 0 ? value.components : 1;
  for (int i = 0; i < components; ++i) items.numbers.push_back(Component(variable, i, value.mark));
  if (HasFailedNumber(items.numbers)) return std::nullopt;
  if (variable.list < 0) return items;
  const auto list = static_cast<std::size_t>(variable.list);
  return Items{lists_[list].numbers(), list_texts_[list]};
}

std::optional<std::size_t> Evaluator::Length(const spec::Value& count, StreamId path) {
  const double number = Number(count, Child(path, "count"));
  if (spec::IsListLength(number)) return static_cast<std::size_t>(number);
  if (!std::isnan(number)) {
    Fail(diag::Code::kSampleBadArgument, count.mark,
         fmt::format("count is {}; it {}", expr::NumberText(number), spec::kListLengthRule));
  }
  return std::nullopt;
}

std::optional<Items> Evaluator::Repeat(const spec::Each& each, StreamId path) {
  const std::optional<std::size_t> count = Length(*each.count, path);
  if (!count) return std::nullopt;
  Items items;
  for (std::size_t i = 0; i < *count; ++i) {
    if (!AppendItem(*each.value, each.value->type, Child(path, i), items)) return std::nullopt;
  }
  return items;
}

// Draws a sort key for each item, so that adding an item at the end does not change the order of
// the other items.
std::vector<std::size_t> Evaluator::RandomPermutation(std::size_t count, StreamId path) const {
  std::vector<double> keys(count);
  for (std::size_t i = 0; i < count; ++i) keys[i] = Uniforms(Child(path, i))[0];
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return keys[i]; });
  return order;
}

std::optional<Items> Evaluator::Arrange(const spec::Arrangement& arrangement, StreamId path) {
  const std::optional<Items> all = List(*arrangement.list, Child(path, "items"));
  std::optional<std::size_t> count = all ? all->numbers.size() : 0;
  if (arrangement.count != nullptr) count = Length(*arrangement.count, path);
  if (!all || !count) return std::nullopt;
  if (*count > all->numbers.size()) {
    Fail(diag::Code::kSampleBadArgument, arrangement.count->mark,
         fmt::format("{} different items are asked of a list that has {}", *count,
                     all->numbers.size()));
    return std::nullopt;
  }
  const std::vector<std::size_t> order = RandomPermutation(all->numbers.size(), path);
  Items items;
  for (std::size_t i = 0; i < *count; ++i) {
    items.numbers.push_back(all->numbers[order[i]]);
    if (!all->texts.empty()) items.texts.push_back(all->texts[order[i]]);
  }
  return items;
}

}  // namespace mjforge::sample
