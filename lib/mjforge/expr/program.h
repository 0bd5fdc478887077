// Compiled program of an expression: a sequence of steps that compute numbers. Private to
// lib/mjforge/expr.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mjforge/expr/builtins.h"
#include "mjforge/expr/lists.h"

namespace mjforge::expr {

/// Operand of a step: a constant, or the result of an earlier step.
struct Operand {
  int step = -1;  // index of the earlier step; -1: the operand is the constant
  double constant = 0;

  bool IsSame(const Operand& other) const;
};

/// Sequence of steps. A call of a Builtin whose operands are all constants becomes a constant
/// (constant folding), and equal steps are added only once.
class Program {
 public:
  Operand Variable(int slot);
  /// Adds a call of a built-in function with one to three operands.
  Operand Apply(const Builtin& builtin, std::span<const Operand> operands);
  Operand Apply(const ListBuiltin& builtin, const ListSource& list, const Operand& argument);
  void SetResult(const Operand& result) { result_ = result; }

  /// Result of the program if it does not depend on variables; otherwise nullopt.
  std::optional<double> constant() const;
  /// Computes the result from the variables, indexed by slot, and the lists, indexed by their
  /// numbers in the SymbolTable.
  double Run(std::span<const double> variables, std::span<const Sequence> lists) const;

  /// An invalid access to a list or vector: an index or a count that is out of range or not a whole
  /// number, or `min` or `max` of an empty list.
  struct OutOfRange {
    const ListBuiltin* builtin;
    ListSource list;
    double argument;
    std::size_t size;
  };
  /// Returns the first invalid access to a list or vector; nullopt if there is none. Ignores an
  /// access whose number is NaN, or whose list contains NaN.
  std::optional<OutOfRange> FindOutOfRange(std::span<const double> variables,
                                           std::span<const Sequence> lists) const;

 private:
  struct Step {
    const Builtin* builtin = nullptr;
    // If `builtin` and `list_builtin` are null, the step reads the variable in `slot`.
    const ListBuiltin* list_builtin = nullptr;
    int slot = -1;
    ListSource list = {};
    std::array<Operand, 3> operands = {};
  };
  Operand Add(const Step& step);
  double Run(std::span<const double> variables, std::span<const Sequence> lists,
             std::span<double> results) const;

  std::vector<Step> steps_;
  Operand result_;
};

}  // namespace mjforge::expr
