#include <fmt/format.h>
#include <muParserBase.h>

#include <limits>
#include <utility>

#include "mjforge/expr/complaints.h"
#include "mjforge/expr/expr.h"
#include "mjforge/expr/grammar.h"

namespace mjforge::expr {
namespace {

// muParser as a bare machine: no names, functions or numbers of its own, only
// the built-in operators and what a formula uses. That makes one cheap to set
// up (mu::Parser defines its 30 functions anew for each), and keeps its number
// reader, which goes through streams and a locale, out of play.
class Machine : public mu::ParserBase {
 public:
  Machine() {
    Machine::InitCharSets();
    Machine::InitOprt();
    // Its optimizer regroups sums and products, which changes last digits.
    EnableOptimizer(false);
  }

 protected:
  void InitCharSets() override {
    DefineNameChars("0123456789cfi");
    DefineOprtChars("%");
    DefineInfixOprtChars("%");
  }
  void InitFun() override {}
  void InitConst() override {}
  void InitOprt() override { DefineOprt("%", Remainder, mu::prMUL_DIV, mu::oaLEFT); }
};

}  // namespace

// The machine reads the values through pointers into this structure, so it must
// stay where it is.
struct Expression::Parsed {
  std::vector<double> inputs;
  std::vector<double> constants;
  Machine machine;

  explicit Parsed(Formula formula)
      : inputs(formula.inputs.size(), 1.0), constants(std::move(formula.constants)) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      machine.DefineVar(fmt::format("i{}", i), &inputs[i]);
    }
    for (std::size_t i = 0; i < constants.size(); ++i) {
      machine.DefineVar(fmt::format("c{}", i), &constants[i]);
    }
    for (std::size_t i = 0; i < formula.callees.size(); ++i) {
      std::visit([&](auto function) { machine.DefineFun(fmt::format("f{}", i), function); },
                 formula.callees[i]->callable);
    }
    machine.SetExpr(formula.text);
    machine.Eval();  // the first evaluation compiles
  }
  Parsed(const Parsed&) = delete;
  Parsed& operator=(const Parsed&) = delete;
};

Expression::Expression() = default;
Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::EvaluateParsed(std::span<const double> variables) const {
  if (!parsed_) {  // a variable alone, or nothing was compiled
    return inputs_.empty() ? std::numeric_limits<double>::quiet_NaN()
                           : variables[static_cast<std::size_t>(inputs_[0].slot)];
  }
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    parsed_->inputs[i] = variables[static_cast<std::size_t>(inputs_[i].slot)];
  }
  try {
    return parsed_->machine.Eval();
  } catch (const mu::ParserError&) {  // muParser's guard against a bug of its own
    return std::numeric_limits<double>::quiet_NaN();
  }
}

std::optional<Expression> Expression::Compile(std::string_view text, const Names& names,
                                              Error& error) {
  Formula formula;
  if (!ParseFormula(text, names, formula, error)) return std::nullopt;
  Expression expression;
  expression.text_ = text;
  expression.type_ = formula.type;
  expression.inputs_ = formula.inputs;
  if (formula.IsLoneOperand()) {
    if (formula.inputs.empty()) expression.constant_ = formula.constants[0];
    return expression;
  }
  try {
    auto parsed = std::make_unique<Parsed>(std::move(formula));
    if (expression.inputs_.empty()) {
      expression.constant_ = parsed->machine.Eval();
    } else {
      expression.parsed_ = std::move(parsed);
    }
  } catch (const mu::ParserError& caught) {
    // The formula is well-formed; what is left are muParser's own limits.
    const bool too_long = caught.GetCode() == mu::ecEXPRESSION_TOO_LONG;
    error = {diag::Code::kExprSyntax, 0,
             too_long ? "the expression has too many parts"
                      : fmt::format("the expression cannot be computed ({})", caught.GetMsg()),
             std::string(kSplitHint)};
    return std::nullopt;
  }
  return expression;
}

}  // namespace mjforge::expr
