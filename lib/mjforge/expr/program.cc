// Compiled program of an expression: adds and runs steps.
#include "mjforge/expr/program.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace mjforge::expr {
namespace {

// Programs with at most this many steps keep their results on the stack, without allocation.
constexpr std::size_t kFewSteps = 32;

}  // namespace

// Compares the bits of constants, because 0 equals -0, but 1 / 0 differs from 1 / -0.
bool Operand::IsSame(const Operand& other) const {
  return step == other.step &&
         std::bit_cast<std::uint64_t>(constant) == std::bit_cast<std::uint64_t>(other.constant);
}

Operand Program::Add(const Step& step) {
  const auto same = std::ranges::find_if(steps_, [&](const Step& other) {
    return other.builtin == step.builtin && other.list_builtin == step.list_builtin &&
           other.slot == step.slot && other.list == step.list &&
           std::ranges::equal(other.operands, step.operands, &Operand::IsSame);
  });
  const auto number = static_cast<int>(same - steps_.begin());
  if (same == steps_.end()) steps_.push_back(step);
  return {.step = number};
}

Operand Program::Variable(int slot) { return Add({.slot = slot}); }

Operand Program::Apply(const Builtin& builtin, std::span<const Operand> operands) {
  if (std::ranges::all_of(operands, [](const Operand& operand) { return operand.step < 0; })) {
    std::array<double, 3> values{};
    std::ranges::transform(operands, values.begin(), &Operand::constant);
    return {.constant = builtin.Call(values)};
  }
  Step step{.builtin = &builtin};
  std::ranges::copy(operands, step.operands.begin());
  return Add(step);
}

Operand Program::Apply(const ListBuiltin& builtin, const ListSource& list,
                       const Operand& argument) {
  return Add({.list_builtin = &builtin, .list = list, .operands = {argument}});
}

std::optional<double> Program::constant() const {
  return result_.step < 0 ? std::optional(result_.constant) : std::nullopt;
}

double Program::Run(std::span<const double> variables, std::span<const Sequence> lists) const {
  if (steps_.size() <= kFewSteps) {
    std::array<double, kFewSteps> results;
    return Run(variables, lists, results);
  }
  std::vector<double> results(steps_.size());
  return Run(variables, lists, results);
}

double Program::Run(std::span<const double> variables, std::span<const Sequence> lists,
                    std::span<double> results) const {
  const auto value = [&](const Operand& operand) {
    return operand.step < 0 ? operand.constant : results[static_cast<std::size_t>(operand.step)];
  };
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const auto& [builtin, list_builtin, slot, list, operands] = steps_[i];
    if (builtin != nullptr) {
      results[i] = builtin->Call({value(operands[0]), value(operands[1]), value(operands[2])});
    } else if (list_builtin != nullptr) {
      results[i] = list_builtin->function(ListValues(list, variables, lists), value(operands[0]));
    } else {
      results[i] = variables[static_cast<std::size_t>(slot)];
    }
  }
  return value(result_);
}

std::optional<Program::OutOfRange> Program::FindOutOfRange(std::span<const double> variables,
                                                           std::span<const Sequence> lists) const {
  std::vector<double> results(steps_.size());
  Run(variables, lists, results);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.list_builtin == nullptr || !std::isnan(results[i])) continue;
    const Operand& operand = step.operands[0];
    const double argument =
        operand.step < 0 ? operand.constant : results[static_cast<std::size_t>(operand.step)];
    const ListValues values(step.list, variables, lists);
    const bool has_all =
        std::ranges::none_of(values.numbers(), [](double n) { return std::isnan(n); });
    if (has_all && !std::isnan(argument))
      return OutOfRange{step.list_builtin, step.list, argument, values.numbers().size()};
  }
  return std::nullopt;
}

}  // namespace mjforge::expr
