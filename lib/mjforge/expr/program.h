// Compiled program of an expression: steps on numbers. Private to lib/mjforge/expr.
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
  int step = -1;  // -1: the constant
  double constant = 0;

  bool IsSame(const Operand& other) const;
};

/// Sequence of steps. Steps that depend on no variable are computed when they are added (constant
/// folding), and equal steps are shared.
class Program {
 public:
  Operand Variable(int slot);
  /// Adds a call; the number of operands is that of the function's arguments, at most three.
  Operand Apply(const Builtin& builtin, std::span<const Operand> operands);
  Operand Apply(const ListBuiltin& builtin, const ListSource& list, const Operand& argument);
  void SetResult(const Operand& result) { result_ = result; }

  /// The result, if it does not depend on variables.
  std::optional<double> constant() const;
  /// Computes the result from the variables (by slot) and the lists.
  double Run(std::span<const double> variables, std::span<const Sequence> lists) const;

  /// An access beyond the end of a list.
  struct OutOfRange {
    const ListBuiltin* builtin;
    ListSource list;
    double argument;
    std::size_t size;
  };
  /// Finds the first access beyond the end of a list.
  std::optional<OutOfRange> FindOutOfRange(std::span<const double> variables,
                                           std::span<const Sequence> lists) const;

 private:
  struct Step {
    const Builtin* builtin = nullptr;
    const ListBuiltin* list_builtin = nullptr;  // null together with builtin: read the variable
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
