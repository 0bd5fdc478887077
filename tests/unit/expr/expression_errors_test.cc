// Tests of the messages and hints for wrong expressions.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;
using mjforge::diag::Code;

namespace {

struct Case {
  std::string text;
  std::size_t offset;
  std::string message;
  std::string hint;
};

SymbolTable KnownNames() {
  SymbolTable names;
  names.Declare("r", Type::kNumber);
  names.Declare("handle_radius", Type::kNumber);
  names.Declare("v", Type::kNumber, 3);
  names.Declare("uv", Type::kNumber, 2);
  names.Declare("solimp", Type::kNumber, 5);
  names.Declare("yes", Type::kBoolean);
  names.Declare("shape", Type::kText);
  names.Declare("lid.top", Type::kNumber);
  return names;
}

void CheckErrors(Code code, const std::vector<Case>& cases) {
  for (const Case& each : cases) {
    CAPTURE(each.text);
    Error error;
    CHECK_FALSE(Expression::Compile(each.text, KnownNames(), error).has_value());
    CHECK(CodeName(error.code) == CodeName(code));
    CHECK(error.offset == each.offset);
    CHECK(error.message == each.message);
    CHECK(error.hint == each.hint);
  }
}

const std::string kSplitHint =
    "move a part of it into a parameter: a parameter may be an expression";

}  // namespace

TEST_CASE("a missing value is reported where it should stand") {
  CheckErrors(
      Code::kExprSyntax,
      {{"", 0, "the expression is empty", ""},
       {"   ", 3, "the expression is empty", ""},
       {"r +", 3, "the expression ends where a value is expected", ""},
       {"2 * * r", 4, "a value is expected before '*'", ""},
       {"2 ** r", 3, "a value is expected before '*'", "write ^ for a power"},
       {"* r", 0, "a value is expected before '*'", ""},
       {"()", 1, "a value is expected before ')'", ""},
       {"r + )", 4, "a value is expected before ')'", ""},
       {"max(r,)", 6, "a value is expected before ')'", ""},
       {"max(,r)", 4, "a value is expected before ','", ""},
       {"r and", 5, "the expression ends where a value is expected", ""},
       {"and r", 0, "a value is expected before 'and'", ""},
       {"r and or r", 6, "a value is expected before 'or'", ""},
       {"r === 1", 4, "a value is expected before '='", "the comparisons are == != < <= > >="},
       {"r <> 1", 3, "a value is expected before '>'", ""},
       {".. 2", 0, "a value is expected before '..'", ""},
       {"yes ? : 2", 6, "a value is expected before ':'", ""}});
}

TEST_CASE("a missing operator is reported at the second value") {
  CheckErrors(Code::kExprSyntax,
              {{"2 r", 2, "an operator is missing before 'r'", "write 2 * r"},
               {"r r", 2, "an operator is missing before 'r'", "write r * r"},
               {"(r) (r)", 4, "an operator is missing before '('", ""},
               {"(r) r", 4, "an operator is missing before 'r'", ""},
               {"2 (r)", 2, "an operator is missing before '('", ""},
               {"r !yes", 2, "an operator is missing before '!'", ""},
               {"r not yes", 2, "an operator is missing before 'not'", ""},
               {"90 deg", 3, "an operator is missing before 'deg'",
                "a unit follows its number without a space: 90deg"},
               {"2 * 15 mm + r", 7, "an operator is missing before 'mm'",
                "a unit follows its number without a space: 15mm"},
               {"r mm", 2, "an operator is missing before 'mm'",
                "only numbers carry units: multiply by 1mm"},
               {"(r + 2) mm", 8, "an operator is missing before 'mm'",
                "only numbers carry units: multiply by 1mm"},
               {"shape 'box'", 6, "an operator is missing before the text 'box'", ""},
               {"1 2", 2, "an operator is missing before '2'", ""}});
}

TEST_CASE("signs that mean something elsewhere are explained") {
  CheckErrors(
      Code::kExprSyntax,
      {{"r = 2", 2, "'=' is not an operator", "write == to compare"},
       {"r & yes", 2, "'&' is not an operator", "write && or 'and'"},
       {"(r | yes)", 3, "'|' is not an operator", "write || or 'or'"},
       {"r .. 2", 2, "a range cannot be part of an expression",
        "draw it as a separate parameter and use that parameter's name"},
       {"r..2", 1, "a range cannot be part of an expression",
        "draw it as a separate parameter and use that parameter's name"},
       {"0,5 * r", 1, "',' only separates the arguments of a function",
        "write decimals with a point: 0.5"},
       {"r, r", 1, "',' only separates the arguments of a function", ""},
       {"(1, r)", 2, "',' only separates the arguments of a function", ""},
       {"r : 2", 2, "':' has no '?' before it", ""},
       {"r $ 2", 2, "unexpected character '$'",
        "inside an expression write only the name, without ${}"},
       {"[1]", 0, "a value is expected before '['", "an expression gives one value, not a list"},
       {"2 × r", 2, "unexpected character '×'", "write * to multiply"},
       {"90°", 2, "unexpected character '°'", "write deg after the number"},
       {"5 − 3", 2, "unexpected character '−'", "write the ASCII minus sign -"},
       {"r ; 2", 2, "unexpected character ';'", ""},
       {"größe", 2, "unexpected character 'ö'", ""},
       {".", 0, "unexpected character '.'", ""}});
}

TEST_CASE("parentheses and choices must be complete") {
  CheckErrors(Code::kExprSyntax, {{"2 * (r + 1", 4, "'(' is not closed", ""},
                                  {"((r)", 0, "'(' is not closed", ""},
                                  {"max(r, 1", 3, "'(' is not closed", ""},
                                  {"r)", 1, "')' has no '(' before it", ""},
                                  {"(r + 1))", 7, "')' has no '(' before it", ""},
                                  {"yes ? 1", 4, "'?' has no ':'", "write condition ? a : b"},
                                  {"(yes ? 1)", 8, "')' has no '(' before it", ""},
                                  {"'box", 0, "the quote is not closed", ""},
                                  {"shape == \"box'", 9, "the quote is not closed", ""}});
}

TEST_CASE("broken numbers are reported whole") {
  CheckErrors(Code::kExprSyntax,
              {{"1.2.3", 0, "'1.2.3' is not a number", ""},
               {"2 * 1.5.x", 4, "'1.5.x' is not a number", ""},
               {"1e999", 0, "'1e999' is too large or too small for a number", ""},
               {"1e-999 * r", 0, "'1e-999' is too large or too small for a number", ""},
               {"0o9", 0, "'0o9' is not an octal number", ""}});
}

TEST_CASE("functions want their parentheses and their number of arguments") {
  CheckErrors(Code::kExprSyntax,
              {{"sin", 0, "'sin' is a function", "write sin(x)"},
               {"len", 0, "'len' is a function", "write len(list)"},
               {"2 * clamp + 1", 4, "'clamp' is a function", "write clamp(x, lo, hi)"},
               {"clamp(r, 1)", 0, "'clamp' takes 3 arguments, not 2", "write clamp(x, lo, hi)"},
               {"1 + sin(r, 2)", 4, "'sin' takes 1 argument, not 2", "write sin(x)"},
               {"sqrt()", 0, "'sqrt' takes 1 argument, not 0", "write sqrt(x)"},
               {"atan2(1)", 0, "'atan2' takes 2 arguments, not 1", "write atan2(y, x)"},
               {"min()", 0, "'min' takes at least 1 argument, not 0", "write min(x, ...)"},
               {"r(2)", 0, "'r' is not a function", "write r * (...)"},
               {"pi (2)", 0, "'pi' is not a function", ""}});
}

TEST_CASE("comparisons cannot be chained") {
  CheckErrors(Code::kExprSyntax,
              {{"0 < r < 1", 6, "comparisons cannot be chained", "write 0 < r and r < ..."},
               {"1 + r <= 2 * r <= 3", 15, "comparisons cannot be chained",
                "write 1 + r <= 2 * r and 2 * r <= ..."},
               {"r == 1 != yes", 7, "comparisons cannot be chained", "write r == 1 and 1 != ..."}});
}

TEST_CASE("'not' needs parentheses where only '!' may stand") {
  CheckErrors(Code::kExprSyntax,
              {{"1 + not yes", 4, "'not' binds more loosely than what precedes it",
                "put it in parentheses: (not ...)"},
               {"yes == not yes", 7, "'not' binds more loosely than what precedes it",
                "put it in parentheses: (not ...)"}});
}

TEST_CASE("an unknown name is reported with the nearest known one") {
  CheckErrors(
      Code::kExprUnknownName,
      {{"2 * handle_radus", 4, "unknown name 'handle_radus'", "did you mean 'handle_radius'?"},
       {"Handle_Radius", 0, "unknown name 'Handle_Radius'", "did you mean 'handle_radius'?"},
       {"zebra", 0, "unknown name 'zebra'", ""},
       {"r + trueish", 4, "unknown name 'trueish'", ""},
       {"sine(r)", 0, "unknown function 'sine'", "did you mean 'sin'?"},
       {"zebra(r)", 0, "unknown function 'zebra'", ""},
       {"lid.tip", 0, "unknown name 'lid.tip'", "did you mean 'lid.top'?"},
       {"lid.top.x.y", 0, "unknown name 'lid.top.x.y'", ""},
       {"10 * mm", 5, "unknown name 'mm'", "a unit follows its number without a space: 1mm"},
       {"shape == cylinder", 9, "unknown name 'cylinder'", "put text in quotes: 'cylinder'"},
       {"r == cylinder", 5, "unknown name 'cylinder'", ""}});
}

TEST_CASE("an unknown unit is reported where it starts") {
  CheckErrors(
      Code::kExprUnknownUnit,
      {{"15MM", 2, "unknown unit 'MM'", "did you mean 'mm'?"},
       {"r + 90degs", 6, "unknown unit 'degs'", "did you mean 'deg'?"},
       {"2r", 1, "unknown unit 'r'", "write 2 * r"},
       {"1.5handle_radius", 3, "unknown unit 'handle_radius'", "write 1.5 * handle_radius"},
       {"3inch", 1, "unknown unit 'inch'", "the units are mm cm m km um deg rad g kg s ms N Nm"},
       {"1e", 1, "unknown unit 'e'", "the units are mm cm m km um deg rad g kg s ms N Nm"},
       {"1_000", 1, "unknown unit '_000'", "the units are mm cm m km um deg rad g kg s ms N Nm"}});
}

TEST_CASE("text is only good for == and != with text") {
  const std::string message = "'shape' is text; it can only be compared with == or !=";
  const std::string beside = "'shape' is text; the other side of the choice is not";
  const std::string in_let =
      "a text with numbers can be a value of `let:`, as in {above: \"link_${i - 1}\"}";
  CheckErrors(Code::kExprType,
              {{"shape", 0, message, ""},
               {"2 * shape", 4, message, ""},
               {"shape + 1", 0, message, ""},
               {"-shape", 1, message, ""},
               {"+shape", 1, message, ""},
               {"!shape", 1, message, ""},
               {"not shape", 4, message, ""},
               {"shape < 'c'", 0, message, ""},
               {"1 < (shape)", 5, message, ""},
               {"shape and yes", 0, message, ""},
               {"yes or shape", 7, message, ""},
               {"max(1, shape)", 7, message, ""},
               {"shape ? 1 : 2", 0, message, ""},
               {"yes ? shape : 'c'", 6, message, ""},
               {"yes ? shape : 2", 6, beside, in_let},
               {"yes ? 1 : shape", 10, beside, in_let},
               {"shape ^ 2", 0, message, ""},
               {"2 ^ shape", 4, message, ""},
               {"(shape)", 1, message, ""},
               {"'box'", 0, "'box' is text; it can only be compared with == or !=", ""},
               {"'box' + 1", 0, "'box' is text; it can only be compared with == or !=", ""},
               {"shape == 1", 0, "'shape' is text; it can only be compared with text", ""},
               {"r != 'box'", 5, "'box' is text; it can only be compared with text", ""},
               {"yes == shape", 7, "'shape' is text; it can only be compared with text", ""}});
}

TEST_CASE("vectors are used by component") {
  CheckErrors(
      Code::kExprType,
      {{"2 * v", 4, "'v' is a vector of 3 numbers; an expression needs a single number",
        "use v.x, v.y or v.z"},
       {"uv", 0, "'uv' is a vector of 2 numbers; an expression needs a single number",
        "use uv.x or uv.y"},
       {"solimp + 1", 0, "'solimp' is a vector of 5 numbers; an expression needs a single number",
        "use solimp.x, solimp.y, solimp.z or solimp.w"},
       {"v.w", 0, "'v' is a vector of 3 numbers; it has no component 'w'", "use v.x, v.y or v.z"},
       {"1 + uv.z", 4, "'uv' is a vector of 2 numbers; it has no component 'z'",
        "use uv.x or uv.y"},
       {"v.xy", 0, "'v' is a vector of 3 numbers; it has no component 'xy'", "use v.x, v.y or v.z"},
       {"r.x", 0, "'r' is a number; it has no component 'x'", ""},
       {"shape.x == 'a'", 0, "'shape' is a text; it has no component 'x'", ""},
       {"lid.top.x", 0, "'lid.top' is a number; it has no component 'x'", ""}});
}

TEST_CASE("an expression of absurd size is refused") {
  CheckErrors(Code::kExprSyntax,
              {{std::string(201, '(') + "r" + std::string(201, ')'), 200,
                "the expression is nested deeper than 200 levels", kSplitHint},
               {std::string(5000, '-') + "r", 199,
                "the expression is nested deeper than 200 levels", kSplitHint},
               {std::string(10'000, ' ') + "r", 0,
                "the expression has 10001 bytes; the limit is 10000", kSplitHint}});
  std::string towers = "2";
  for (int i = 0; i < 1000; ++i) towers += "^2";
  std::string choices = "1";
  for (int i = 0; i < 1000; ++i) choices += " ? 1 : 1";
  std::string nots;
  for (int i = 0; i < 1000; ++i) nots += "not ";
  for (const std::string& text : {towers, choices, nots + "r"}) {
    Error error;
    CHECK_FALSE(Expression::Compile(text, KnownNames(), error).has_value());
    CHECK(error.message == "the expression is nested deeper than 200 levels");
  }
}

TEST_CASE("bytes of any kind never crash the compiler") {
  const std::string alphabet = "rv.x()+-*/^%<>=!&|?:,'\" 0123456789emnot andmax\xc3\xb6\n${}[]\\#@";
  unsigned state = 12345;
  const auto next = [&state] { return (state = state * 1664525u + 1013904223u) >> 16; };
  const SymbolTable names = KnownNames();
  int compiled = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string text;
    for (unsigned length = next() % 12; length > 0; --length) {
      text += alphabet[next() % alphabet.size()];
    }
    Error error;
    if (Expression::Compile(text, names, error)) {
      ++compiled;
    } else if (error.message.empty() || error.offset > text.size()) {
      FAIL("no proper error for: " << text);
    }
  }
  CHECK(compiled > 100);
}
