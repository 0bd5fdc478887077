// Expressions in specs: compilation, evaluation, built-in functions and units. Also converts
// numbers to text and back. All results are independent of the locale.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/dimension.h"
#include "mjforge/expr/rounded_text.h"
#include "mjforge/expr/symbol_table.h"

namespace mjforge::expr {

/// Appends a finite number, rounded correctly to at most 10 significant digits and without trailing
/// zeros: "0.015", "1e-08", "-3". Appends -0 as "0".
void AppendNumber(std::string& out, double value);
std::string NumberText(double value);
/// Size in bytes of a buffer that suffices for WriteNumber() and WriteExactNumber(), including the
/// bytes after the end of the text that these functions may overwrite.
inline constexpr std::size_t kLongestNumber = 40;
/// Writes the same text as AppendNumber() to `out`, and returns the end of the text. `out` must
/// have room for kLongestNumber bytes, all of which may be overwritten.
char* WriteNumber(char* out, double value);

/// Appends the shortest text that is parsed as exactly `value` (finite). Files that record the
/// values of a variant use this form, because the variant must be reproducible to the last bit.
void AppendExactNumber(std::string& out, double value);
char* WriteExactNumber(char* out, double value);
std::string ExactNumberText(double value);

/// Parses a text that is a number in YAML 1.2 (`3`, `-0.5`, `1e-3`, `.5`, `0x1F`, `0o17`). Returns
/// nullopt for other texts, for `.inf` and `.nan`, and for numbers outside the range of a double
/// or, with `0x` and `0o`, of 64 bits.
std::optional<double> ParseNumber(std::string_view text);

/// Returns true for an ASCII letter followed by ASCII letters, digits and underscores.
bool IsName(std::string_view text);
bool IsNameCharacter(char c);
/// Returns true for 0 to 9, in every locale.
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// Returns true if `words`, a list of words separated by single spaces, contains `word`.
bool HasWord(std::string_view words, std::string_view word);
/// Splits a text at spaces, tabs and line ends.
std::vector<std::string_view> WordsOf(std::string_view text);

/// A list that an expression can read: the items as numbers, and the prefix sums of these numbers.
/// A text item is represented by its TextKey().
class Sequence {
 public:
  Sequence() : Sequence(std::vector<double>()) {}
  explicit Sequence(std::vector<double> numbers);

  const std::vector<double>& numbers() const { return numbers_; }
  /// Returns the sum of the first `count` numbers, added from left to right; 0 <= `count` <= size.
  double SumOf(std::size_t count) const { return sums_[count]; }

 private:
  std::vector<double> numbers_;
  std::vector<double> sums_;  // sums_[i] is the sum of the first i numbers
};

struct Error {
  diag::Code code = diag::Code::kExprSyntax;
  std::size_t offset = 0;  // byte offset in the expression's text, or in the body of `function`
  std::string message;
  std::string hint;
  std::string function = {};  // spec function that has the error; empty: the expression
};

class Program;  // private to lib/mjforge/expr

/// A compiled expression. Copies share the compiled program.
class Expression {
 public:
  struct Input {
    std::string name;  // name as in the expression: "r", "size.x", or that of a list
    int slot = 0;
    Type type = Type::kNumber;  // for a list, the type of its items
    int list = -1;              // index in the array of lists; -1: not a list
  };

  const std::string& text() const { return text_; }
  /// Type of the result. If the type is kText, Evaluate() returns the TextKey() of one of texts(),
  /// or of a text in a variable or list of inputs().
  Type type() const { return type_; }
  /// Dimension of the result.
  const Dimension& dimension() const { return dimension_; }
  std::span<const Input> inputs() const { return inputs_; }
  /// Texts in quotes that occur in the expression.
  const std::vector<std::string>& texts() const { return texts_; }
  /// Names of the spec's functions that the expression calls, directly or through other functions.
  const std::set<std::string>& functions() const { return functions_; }
  /// Value of the expression if it does not depend on variables or items of lists; otherwise
  /// nullopt.
  std::optional<double> constant() const { return constant_; }

  /// Computes the value from variables, indexed by slot, and lists, indexed by list number; the
  /// SymbolTable that Compile() used assigns both. The result may be NaN or infinite; the caller
  /// must report such a result. An operand that is NaN makes the result NaN, unless `and`, `or` or
  /// `?:` ignores this operand.
  double Evaluate(std::span<const double> variables, std::span<const Sequence> lists = {}) const {
    return constant_ ? *constant_ : Run(variables, lists);
  }
  /// Returns a message about the first invalid access to a list or vector ("there is no widths[7]:
  /// 'widths' has 5 values"); an empty text if there is none. Program::OutOfRange defines invalid
  /// accesses.
  std::string DescribeMissingItem(std::span<const double> variables,
                                  std::span<const Sequence> lists) const;

  enum class Result { kNoText, kAny };
  /// Compiles `text`. On failure, returns nullopt and sets `error`. A text as the result is an
  /// error if `result` is kNoText. docs/manual.md, "Expressions", describes the language.
  static std::optional<Expression> Compile(std::string_view text, const SymbolTable& names,
                                           Error& error, Result result = Result::kNoText);

 private:
  Expression() = default;
  double Run(std::span<const double> variables, std::span<const Sequence> lists) const;

  std::string text_;
  Type type_ = Type::kNumber;
  Dimension dimension_;
  std::vector<Input> inputs_;
  std::vector<std::string> texts_;
  std::set<std::string> functions_;
  std::optional<double> constant_;
  std::shared_ptr<const Program> program_;
};

/// Returns the names in `text`, in order of first use, without reserved names (see IsReserved()). A
/// component of a vector is returned as the name of the vector. Returns an empty list if `text` has
/// invalid tokens. The dependency graph of parameters is made from these names before any name is
/// declared.
std::vector<std::string> NamesUsedIn(std::string_view text);

/// Returns true for names that a spec must not define: `and`, `or`, `not`, the constants (`pi`),
/// and the built-in functions (`min`) except `len`, `sum`, `torque` and `distance`.
bool IsReserved(std::string_view name);

/// Documentation of a built-in function or constant for messages and the manual.
struct BuiltinInfo {
  std::string_view name;
  std::string_view usage;  // "clamp(x, lo, hi)"
  std::string_view doc;
};
/// Returns all built-in functions and constants, sorted by name.
std::span<const BuiltinInfo> Builtins();

/// A unit that can follow a number ("mm", "deg"). The number times numerator / denominator is the
/// value in SI units. Two factors are needed, because 15 / 1000 is the double nearest to 0.015, but
/// 15 * 0.001 is not.
struct Unit {
  std::string_view name;
  std::string_view doc;
  Dimension dimension;
  double numerator = 1;
  double denominator = 1;
};
std::span<const Unit> Units();
/// Returns the unit with this name; null if there is none.
const Unit* FindUnitSuffix(std::string_view name);

}  // namespace mjforge::expr
