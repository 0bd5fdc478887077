// The part of Evaluator that makes lists.

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {

using expr::Type;

Items Evaluator::List(const spec::Value& value, StreamId path) {
  Items items;
  if (const auto* list = std::get_if<spec::List>(&value.form)) {
    for (std::size_t i = 0; i < list->items.size(); ++i)
      AppendItem(list->items[i], value.type, ItemStream(list->items[i], path, i), items);
  } else if (const auto* variable = std::get_if<spec::VariableReference>(&value.form)) {
    items = Whole(*variable, value.components);
  } else if (const auto* each = std::get_if<spec::Each>(&value.form)) {
    items = Repeated(*each, path);
  } else if (const auto* arrangement = std::get_if<spec::Arrangement>(&value.form)) {
    items = Arranged(*arrangement, path);
  } else if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    items = List(chosen, path);
  }
  return items;
}

void Evaluator::AppendItem(const spec::Value& item, Type type, StreamId path, Items& out) {
  if (type == Type::kText) {
    out.texts.push_back(Text(item, path));
    out.numbers.push_back(expr::TextKey(out.texts.back()));
  } else {
    out.numbers.push_back(Number(item, path));
  }
}

Items Evaluator::Whole(const spec::VariableReference& variable, int components) {
  Items items;
  if (variable.list < 0) {
    for (int i = 0; i < components; ++i) items.numbers.push_back(Variable(variable.slot + i));
    return items;
  }
  const auto list = static_cast<std::size_t>(variable.list);
  const std::vector<double>& numbers = lists_[list].numbers();
  items.numbers.assign(numbers.begin(), numbers.end());
  items.texts = list_texts_[list];
  return items;
}

std::optional<std::size_t> Evaluator::Length(const spec::Value& count, StreamId path) {
  const double number = Number(count, Child(path, "count"));
  if (spec::IsListLength(number)) return static_cast<std::size_t>(number);
  if (!failed_) {
    Fail(diag::Code::kSampleBadArgument, count.mark,
         fmt::format("count is {}; it {}", expr::NumberText(number), spec::kListLengthRule));
  }
  return std::nullopt;
}

Items Evaluator::Repeated(const spec::Each& each, StreamId path) {
  Items items;
  const std::size_t count = Length(*each.count, path).value_or(0);
  for (std::size_t i = 0; i < count && !failed_; ++i)
    AppendItem(*each.value, each.value->type, Child(path, i), items);
  return items;
}

// By a number drawn for each: one item more leaves the order of the others as it is.
std::vector<std::size_t> Evaluator::Order(std::size_t count, StreamId path) const {
  std::vector<double> keys(count);
  for (std::size_t i = 0; i < count; ++i) keys[i] = Uniforms(Child(path, i))[0];
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return keys[i]; });
  return order;
}

Items Evaluator::Arranged(const spec::Arrangement& arrangement, StreamId path) {
  const Items all = List(*arrangement.list, Child(path, "items"));
  std::size_t count = all.numbers.size();
  if (arrangement.count != nullptr) {
    const std::size_t wanted = Length(*arrangement.count, path).value_or(0);
    if (wanted > count) {
      Fail(diag::Code::kSampleBadArgument, arrangement.count->mark,
           fmt::format("{} different items are asked of a list that has {}", wanted, count));
      return {};
    }
    count = wanted;
  }
  const std::vector<std::size_t> order = Order(all.numbers.size(), path);
  Items items;
  for (std::size_t i = 0; i < count; ++i) {
    items.numbers.push_back(all.numbers[order[i]]);
    if (!all.texts.empty()) items.texts.push_back(all.texts[order[i]]);
  }
  return items;
}

}  // namespace mjforge::sample
