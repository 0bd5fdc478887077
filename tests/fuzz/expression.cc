// Expressions: compiling them, and computing them with odd numbers.

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "fuzz/input.h"
#include "mjforge/expr/expr.h"

namespace mjforge::fuzz {
namespace {

constexpr std::array kValues = {0.0,   1.0,    -1.0,   0.5,   3.0,
                                1e-30, -1e300, 0x1p53, 1e308, std::numeric_limits<double>::min()};

bool IsSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void CheckNumber(double value) {
  if (!std::isfinite(value)) return;
  const auto read = expr::ParseNumber(expr::ExactNumberText(value));
  Must(read && *read == value, "a number is read back as another one");
  Must(expr::ParseNumber(expr::NumberText(value)).has_value(), "a number's text is no number");
}

}  // namespace

void Run(Input input) {
  expr::SymbolTable names;
  names.Declare("index", expr::Type::kNumber);
  names.Declare("r", expr::Type::kNumber);
  names.Declare("size", expr::Type::kNumber, 3);
  names.Declare("flag", expr::Type::kBoolean);
  names.Declare("word", expr::Type::kText);
  std::vector<double> variables;
  for (int i = 0; i < names.slot_count(); ++i)
    variables.push_back(kValues[input.Below(kValues.size())]);

  const std::string_view text = input.Rest();
  if (const std::optional<double> number = expr::ParseNumber(text)) CheckNumber(*number);
  expr::NamesUsedIn(text);
  expr::Error error;
  const auto expression = expr::Expression::Compile(text, names, error);
  if (!expression) {
    Must(!error.message.empty(), "an expression is refused without a reason");
    Must(error.offset <= text.size(), "an error is beyond the expression");
    return;
  }
  const double value = expression->Evaluate(variables);
  Must(IsSame(value, expression->Evaluate(variables)), "an expression has two values");
  CheckNumber(value);
}

}  // namespace mjforge::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  mjforge::fuzz::Run({bytes, size});
  return 0;
}
