// Built-in functions of lists and vectors: element, len, sum, min, max. Private to
// lib/mjforge/expr.
#pragma once

#include <span>
#include <string_view>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

/// Reference to a list or a vector among the variables of an expression.
struct ListSource {
  int slot = -1;       // slot of a list's length or of a vector's first component
  int list = -1;       // number of the list; -1: a vector
  int components = 0;  // number of components of a vector

  bool operator==(const ListSource&) const = default;
};

/// The numbers of a list or a vector.
class ListValues {
 public:
  ListValues(const ListSource& source, std::span<const double> variables,
             std::span<const Sequence> lists);

  std::span<const double> numbers() const { return numbers_; }
  /// Returns the sum of the first `count` numbers, in [0, size].
  double SumOf(std::size_t count) const;

 private:
  std::span<const double> numbers_;
  const Sequence* sequence_ = nullptr;
};

/// A function of a list and a number. Some functions ignore the number. The result is NaN if the
/// list has too few numbers.
struct ListBuiltin {
  std::string_view name;  // "[]" is the access to an element
  double (*function)(const ListValues& list, double argument);
};

/// Finds "[]", "len", "sum" (of the first numbers), "min" or "max"; returns null for other names.
const ListBuiltin* FindListBuiltin(std::string_view name);

}  // namespace mjforge::expr
