#include "mjforge/expr/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mjforge::expr {

void Formula::WriteConstant(double value) {
  fmt::format_to(std::back_inserter(text), "c{}", constants.size());
  constants.push_back(value);
}

void Formula::WriteInput(std::string_view name, int slot, Type input_type) {
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [slot](const auto& input) { return input.slot == slot; });
  fmt::format_to(std::back_inserter(text), "i{}", found - inputs.begin());
  if (found == inputs.end()) inputs.push_back({std::string(name), slot, input_type});
}

void Formula::WriteCall(const Callee& callee) {
  const auto found = std::find(callees.begin(), callees.end(), &callee);
  fmt::format_to(std::back_inserter(text), "f{}(", found - callees.begin());
  if (found == callees.end()) callees.push_back(&callee);
}

}  // namespace mjforge::expr
