#include "mjforge/expr/program.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace mjforge::expr {
namespace {

// How many steps need no memory of their own.
constexpr std::size_t kFewSteps = 32;

}  // namespace

// Zero and minus zero differ: one over them does.
bool Operand::IsSame(const Operand& other) const {
  return step == other.step &&
         std::bit_cast<std::uint64_t>(constant) == std::bit_cast<std::uint64_t>(other.constant);
}

Operand Program::Add(const Step& step) {
  const auto same = std::ranges::find_if(steps_, [&](const Step& other) {
    return other.callee == step.callee && other.slot == step.slot &&
           std::ranges::equal(other.operands, step.operands, &Operand::IsSame);
  });
  const auto number = static_cast<int>(same - steps_.begin());
  if (same == steps_.end()) steps_.push_back(step);
  return {.step = number};
}

Operand Program::Variable(int slot) {
  return Add({.callee = nullptr, .slot = slot, .operands = {}});
}

Operand Program::Apply(const Callee& callee, std::span<const Operand> operands) {
  if (std::ranges::all_of(operands, [](const Operand& operand) { return operand.step < 0; })) {
    std::array<double, 3> values{};
    std::ranges::transform(operands, values.begin(), &Operand::constant);
    return {.constant = callee.Call(values)};
  }
  Step step{.callee = &callee, .slot = -1, .operands = {}};
  std::ranges::copy(operands, step.operands.begin());
  return Add(step);
}

std::optional<double> Program::constant() const {
  return result_.step < 0 ? std::optional(result_.constant) : std::nullopt;
}

double Program::Run(std::span<const double> variables) const {
  if (steps_.size() <= kFewSteps) {
    std::array<double, kFewSteps> results;
    return Run(variables, results);
  }
  std::vector<double> results(steps_.size());
  return Run(variables, results);
}

double Program::Run(std::span<const double> variables, std::span<double> results) const {
  const auto value = [&](const Operand& operand) {
    return operand.step < 0 ? operand.constant : results[static_cast<std::size_t>(operand.step)];
  };
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const auto& [callee, slot, operands] = steps_[i];
    results[i] = callee == nullptr
                     ? variables[static_cast<std::size_t>(slot)]
                     : callee->Call({value(operands[0]), value(operands[1]), value(operands[2])});
  }
  return value(result_);
}

}  // namespace mjforge::expr
