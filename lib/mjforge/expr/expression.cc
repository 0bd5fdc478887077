#include "mjforge/expr/expr.h"
#include "mjforge/expr/grammar.h"

namespace mjforge::expr {

double Expression::Run(std::span<const double> variables) const { return program_->Run(variables); }

std::optional<Expression> Expression::Compile(std::string_view text, const Names& names,
                                              Error& error, Result result) {
  Parsed parsed;
  if (!Parse(text, names, result, parsed, error)) return std::nullopt;
  Expression expression;
  expression.text_ = text;
  expression.type_ = parsed.type;
  expression.inputs_ = std::move(parsed.inputs);
  expression.texts_ = std::move(parsed.texts);
  expression.formulas_ = std::move(parsed.formulas);
  expression.constant_ = parsed.program.constant();
  expression.program_ = std::make_shared<const Program>(std::move(parsed.program));
  return expression;
}

}  // namespace mjforge::expr
