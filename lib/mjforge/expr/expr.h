#pragma once

// The little language of numbers: how they are read, written and computed.
// Nothing here depends on the locale.

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
#include "mjforge/expr/names.h"
#include "mjforge/expr/rounded_text.h"

namespace mjforge::expr {

/// Appends `value` (finite) with at most 10 significant digits, correctly
/// rounded, as short as possible: "0.015", "1e-08", "-3". Never "-0".
void AppendNumber(std::string& out, double value);
std::string NumberText(double value);
/// Bytes that the functions below may write: a sign, 16 digits, a point, zeros.
inline constexpr std::size_t kLongestNumber = 40;
/// The same into memory. Returns the end; what is behind it may be overwritten, too.
char* WriteNumber(char* out, double value);

/// The shortest text that reads back as `value` (finite); for records that
/// must reproduce a value to the last bit.
void AppendExactNumber(std::string& out, double value);
char* WriteExactNumber(char* out, double value);
std::string ExactNumberText(double value);

/// A plain YAML 1.2 number (`3`, `-0.5`, `1e-3`, `.5`, `0x1F`, `0o17`), the
/// whole text. `.inf` and `.nan` are not numbers here.
std::optional<double> ParseNumber(std::string_view text);

/// Whether it is a letter, then letters, digits and underscores, all of ASCII.
bool IsName(std::string_view text);
bool IsNameCharacter(char c);
/// 0 to 9, in every locale.
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// The words of a text, separated by spaces or line ends.
std::vector<std::string_view> WordsOf(std::string_view text);

/// The numbers of a list (of texts their TextKey()s), and the sums of its first ones.
class Sequence {
 public:
  Sequence() : Sequence(std::vector<double>()) {}
  explicit Sequence(std::vector<double> numbers);

  const std::vector<double>& numbers() const { return numbers_; }
  /// Of the first `count`, of [0, size], added one after the other.
  double SumOf(std::size_t count) const { return sums_[count]; }

 private:
  std::vector<double> numbers_;
  std::vector<double> sums_;  // of none, of the first, of the first two, ...
};

struct Error {
  diag::Code code = diag::Code::kExprSyntax;
  std::size_t offset = 0;  // byte in the expression's text
  std::string message;
  std::string hint;
  std::string formula = {};  // in whose body the offset is; empty: in the text itself
};

class Program;  // private to the room

/// One compiled expression; copies share what was compiled.
class Expression {
 public:
  struct Input {
    std::string name;  // as written: "r", "size.x"; of a list or vector used whole, its name
    int slot = 0;
    Type type = Type::kNumber;  // of a list, its items'
    int list = -1;
  };

  const std::string& text() const { return text_; }
  /// Of the result. A text is a TextKey(): of one of texts(), or of an input.
  Type type() const { return type_; }
  /// What the result measures.
  const Dimension& dimension() const { return dimension_; }
  std::span<const Input> inputs() const { return inputs_; }
  /// The texts that it has in quotes.
  const std::vector<std::string>& texts() const { return texts_; }
  /// Names of the functions of the spec that it calls, by others, too.
  const std::set<std::string>& formulas() const { return formulas_; }
  /// The value if there are no inputs.
  std::optional<double> constant() const { return constant_; }

  /// Variables by the slots of the Names it was compiled with, and its lists. The result may
  /// be NaN or infinite: the caller reports it with the inputs' values. What is computed from NaN
  /// is NaN.
  double Evaluate(std::span<const double> variables, std::span<const Sequence> lists = {}) const {
    return constant_ ? *constant_ : Run(variables, lists);
  }
  /// Which list has too few values ("there is no widths[7]: 'widths' has 5 values"); empty: none.
  std::string WhatIsMissing(std::span<const double> variables,
                            std::span<const Sequence> lists) const;

  enum class Result { kNoText, kAny };
  /// Compiles `text`. On failure returns nothing and fills `error`.
  /// Operators, functions and units: docs/manual.md, "Expressions".
  static std::optional<Expression> Compile(std::string_view text, const Names& names, Error& error,
                                           Result result = Result::kNoText);

 private:
  Expression() = default;
  double Run(std::span<const double> variables, std::span<const Sequence> lists) const;

  std::string text_;
  Type type_ = Type::kNumber;
  Dimension dimension_;
  std::vector<Input> inputs_;
  std::vector<std::string> texts_;
  std::set<std::string> formulas_;
  std::optional<double> constant_;
  std::shared_ptr<const Program> program_;
};

/// The names in `text` that are neither built-in functions nor constants, in order of
/// first use, vectors without their component; nothing if it cannot be split
/// into words. For the graph of parameters, before anything is declared.
std::vector<std::string> NamesUsedIn(std::string_view text);

/// Whether a name means something in every expression, so that nothing else may have it: `pi`,
/// `min`, `and`.
bool IsReserved(std::string_view name);

/// The functions and constants an expression may use, sorted; each with one
/// line of explanation, for messages and the manual.
struct Function {
  std::string_view name;
  std::string_view usage;  // "clamp(x, lo, hi)"
  std::string_view doc;
};
std::span<const Function> Functions();

/// Units a number may carry ("mm", "deg"), each with its value in SI units.
struct Unit {
  std::string_view name;
  std::string_view doc;
};
std::span<const Unit> Units();

}  // namespace mjforge::expr
