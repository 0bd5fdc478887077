// Expression: compilation, evaluation, and the message about an invalid access to a list or vector.
#include <algorithm>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/expr/parser.h"

namespace mjforge::expr {

double Expression::Run(std::span<const double> variables, std::span<const Sequence> lists) const {
  return program_->Run(variables, lists);
}

std::string Expression::DescribeMissingItem(std::span<const double> variables,
                                            std::span<const Sequence> lists) const {
  const auto access = program_->FindOutOfRange(variables, lists);
  if (!access) return {};
  const auto input = std::ranges::find_if(inputs_, [&](const Input& one) {
    return one.slot == access->list.slot && one.list == access->list.list;
  });
  const bool is_vector = input->list < 0;  // input->name is then that of a component, "size.x"
  const std::string name = is_vector ? input->name.substr(0, input->name.rfind('.')) : input->name;
  const std::string has = fmt::format("'{}' has {}", name, diag::Counted(access->size, "value"));
  if (access->builtin == FindListBuiltin("[]"))
    return fmt::format("there is no {}[{}]: {}, counted from 0", name, NumberText(access->argument),
                       has);
  if (access->builtin == FindListBuiltin("sum"))
    return fmt::format("there are no first {} of '{}': {}", NumberText(access->argument), name,
                       has);
  return fmt::format("'{}' has no values, so there is no {} of them", name, access->builtin->name);
}

std::optional<Expression> Expression::Compile(std::string_view text, const SymbolTable& names,
                                              Error& error, Result result) {
  ParsedExpression parsed;
  if (!Parse(text, names, result, parsed, error)) return std::nullopt;
  Expression expression;
  expression.text_ = text;
  expression.type_ = parsed.type;
  expression.dimension_ = parsed.dimension;
  expression.inputs_ = std::move(parsed.inputs);
  expression.texts_ = std::move(parsed.texts);
  expression.functions_ = std::move(parsed.functions);
  expression.constant_ = parsed.program.constant();
  expression.program_ = std::make_shared<const Program>(std::move(parsed.program));
  return expression;
}

}  // namespace mjforge::expr
