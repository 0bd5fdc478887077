// Built-in functions of lists and vectors, and prefix sums of lists.
#include "mjforge/expr/lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace mjforge::expr {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool IsCount(double number, std::size_t most) {
  return number >= 0 && number <= static_cast<double>(most) && number == std::floor(number);
}

double Element(const ListValues& list, double index) {
  const auto numbers = list.numbers();
  return IsCount(index + 1, numbers.size()) && index >= 0 ? numbers[static_cast<std::size_t>(index)]
                                                          : kNone;
}

double Sum(const ListValues& list, double count) {
  return IsCount(count, list.numbers().size()) ? list.SumOf(static_cast<std::size_t>(count))
                                               : kNone;
}

constexpr std::array kListBuiltins = {
    ListBuiltin{"[]", Element},
    ListBuiltin{"len", [](const ListValues& list,
                          double) { return static_cast<double>(list.numbers().size()); }},
    ListBuiltin{"sum", Sum},
    ListBuiltin{"min",
                [](const ListValues& list, double) {
                  return list.numbers().empty() ? kNone : std::ranges::min(list.numbers());
                }},
    ListBuiltin{"max",
                [](const ListValues& list, double) {
                  return list.numbers().empty() ? kNone : std::ranges::max(list.numbers());
                }},
};

}  // namespace

Sequence::Sequence(std::vector<double> numbers) : numbers_(std::move(numbers)) {
  sums_.reserve(numbers_.size() + 1);
  double sum = 0;
  sums_.push_back(sum);
  for (const double number : numbers_) sums_.push_back(sum += number);
}

ListValues::ListValues(const ListSource& source, std::span<const double> variables,
                       std::span<const Sequence> lists) {
  if (source.list >= 0) {
    sequence_ = &lists[static_cast<std::size_t>(source.list)];
    numbers_ = sequence_->numbers();
  } else {
    numbers_ = variables.subspan(static_cast<std::size_t>(source.slot),
                                 static_cast<std::size_t>(source.components));
  }
}

double ListValues::SumOf(std::size_t count) const {
  if (sequence_ != nullptr) return sequence_->SumOf(count);
  const auto first = numbers_.first(count);
  return std::accumulate(first.begin(), first.end(), 0.0);
}

const ListBuiltin* FindListBuiltin(std::string_view name) {
  return diag::Find(kListBuiltins, name, &ListBuiltin::name);
}

}  // namespace mjforge::expr
