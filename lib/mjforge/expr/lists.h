// Built-in functions of lists and vectors: element, len, sum, min, max. Private to
// lib/mjforge/expr.
#pragma once

#include <span>
#include <string_view>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

/// Reference to a list or a vector that is a variable of an expression.
struct ListSource {
  int slot = -1;       // slot of the list's length, or of the vector's first component
  int list = -1;       // index in the array of lists; -1 for a vector
  int components = 0;  // number of components of a vector

  bool operator==(const ListSource&) const = default;
};

/// The numbers of a list or a vector.
class ListValues {
 public:
  ListValues(const ListSource& source, std::span<const double> variables,
             std::span<const Sequence> lists);

  std::span<const double> numbers() const { return numbers_; }
  /// Returns the sum of the first `count` numbers; 0 <= `count` <= size.
  double SumOf(std::size_t count) const;

 private:
  std::span<const double> numbers_;
  const Sequence* sequence_ = nullptr;
};

/// A built-in function with two arguments: a list or vector, and a number, which is an index or the
/// count of values to add. `len`, `min` and `max` ignore the number. The result is NaN if the
/// number is not a valid index or count, and for `min` and `max` of an empty list.
struct ListBuiltin {
  std::string_view name;  // "[]" for the access to an element
  double (*function)(const ListValues& list, double argument);
};

/// Returns the function "[]", "len", "sum" (of the first `count` values), "min" or "max"; null for
/// other names.
const ListBuiltin* FindListBuiltin(std::string_view name);

}  // namespace mjforge::expr
