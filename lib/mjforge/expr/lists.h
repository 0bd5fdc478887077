#pragma once

// Private to the room: what the language computes from lists.

#include <span>
#include <string_view>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

/// A list or a vector that an expression names.
struct ListSource {
  int slot = -1;       // of its length; of a vector's first component
  int list = -1;       // its number among the lists; -1: a vector
  int components = 0;  // of a vector

  bool operator==(const ListSource&) const = default;
};

/// The numbers of one.
class ListValues {
 public:
  ListValues(const ListSource& source, std::span<const double> variables,
             std::span<const Sequence> lists);

  std::span<const double> numbers() const { return numbers_; }
  /// Of the first `count`, of [0, size].
  double SumOf(std::size_t count) const;

 private:
  std::span<const double> numbers_;
  const Sequence* sequence_ = nullptr;
};

/// What is computed from a list and a number, which not all of them use; NaN if the list has too
/// few numbers.
struct ListCallee {
  std::string_view name;  // "[]" for an element
  double (*function)(const ListValues& list, double argument);
};

/// "[]", "len", "sum" (of the first ones), "min", "max"; null for other names.
const ListCallee* FindListCallee(std::string_view name);

}  // namespace mjforge::expr
