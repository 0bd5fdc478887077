#pragma once

// Private to the room: what is left of an expression once it has been read.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mjforge/expr/functions.h"
#include "mjforge/expr/lists.h"

namespace mjforge::expr {

/// A number that a program uses: a constant, or what one of its steps gave.
struct Operand {
  int step = -1;  // -1: the constant
  double constant = 0;

  bool IsSame(const Operand& other) const;
};

/// Steps in a row. What depends on no variable is computed as it is added, and no step is made
/// twice.
class Program {
 public:
  Operand Variable(int slot);
  /// As many operands as the function takes, at most three.
  Operand Apply(const Callee& callee, std::span<const Operand> operands);
  Operand Apply(const ListCallee& callee, const ListSource& list, const Operand& argument);
  void SetResult(const Operand& result) { result_ = result; }

  /// The result if no variable has a part in it.
  std::optional<double> constant() const;
  /// The result for the variables, by slot, and the lists.
  double Run(std::span<const double> variables, std::span<const Sequence> lists) const;

  /// A list that has too few numbers for what is asked of it.
  struct Miss {
    const ListCallee* callee;
    ListSource list;
    double argument;
    std::size_t size;
  };
  /// The first one of a run.
  std::optional<Miss> FindMiss(std::span<const double> variables,
                               std::span<const Sequence> lists) const;

 private:
  struct Step {
    const Callee* callee = nullptr;
    const ListCallee* list_callee = nullptr;  // both null: reads the variable
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
