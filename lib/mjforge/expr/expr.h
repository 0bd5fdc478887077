#pragma once

// The little language of numbers: how they are read, written and computed.
// Nothing here depends on the locale.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::expr {

/// Appends `value` (finite) with at most 10 significant digits, correctly
/// rounded, as short as possible: "0.015", "1e-08", "-3". Never "-0".
void AppendNumber(std::string& out, double value);
std::string NumberText(double value);

/// The shortest text that reads back as `value` (finite); for records that
/// must reproduce a value to the last bit.
void AppendExactNumber(std::string& out, double value);
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

enum class Type { kNumber, kBoolean, kText };
std::string_view TypeName(Type type);  // "number", "boolean", "text"

/// The number that represents a text among an expression's variables: 52 bits of the text's XXH64.
/// Equal texts have equal numbers; different texts in practice never do.
double TextKey(std::string_view text);

/// A function that a spec defines: an expression of its arguments, which are numbers, and of the
/// names in scope. It must not call itself, by others neither.
struct Formula {
  std::string name;
  std::vector<std::string> arguments;
  std::string body;
  diag::SourceMark mark = {};  // of the body

  std::string Usage() const;  // "bulge(z)"
};

/// The names an expression may use, and the slot of each in the array of
/// variables that Evaluate() takes. A vector `v` of n components fills n slots,
/// read as `v.x v.y v.z v.w`; booleans are 0 and 1; texts are TextKey()s.
/// Slots are never reused: forgetting a name leaves a hole.
class Names {
 public:
  struct Variable {
    std::string name;
    Type type = Type::kNumber;
    int slot = 0;
    int components = 1;
  };

  /// Returns the first slot. The name must not be declared already.
  int Declare(std::string name, Type type, int components = 1);
  /// Ends a name's scope (a loop's variable).
  void Forget(std::string_view name);
  const Variable* Find(std::string_view name) const;
  /// Adds a function; one of that name is replaced.
  void Define(Formula formula);
  const Formula* FindFormula(std::string_view name) const;
  const std::map<std::string, Formula, std::less<>>& formulas() const { return formulas_; }
  /// The variables in scope, sorted by name.
  std::vector<const Variable*> variables() const;
  int slot_count() const { return slot_count_; }

 private:
  std::map<std::string, Variable, std::less<>> variables_;
  std::map<std::string, Formula, std::less<>> formulas_;
  int slot_count_ = 0;
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
    std::string name;  // as written: "r", "size.x"
    int slot = 0;
    Type type = Type::kNumber;
  };

  const std::string& text() const { return text_; }
  /// Of the result. A text is a TextKey(): of one of texts(), or of an input.
  Type type() const { return type_; }
  std::span<const Input> inputs() const { return inputs_; }
  /// The texts that it has in quotes.
  const std::vector<std::string>& texts() const { return texts_; }
  /// Names of the functions of the spec that it calls, by others, too.
  const std::set<std::string>& formulas() const { return formulas_; }
  /// The value if there are no inputs.
  std::optional<double> constant() const { return constant_; }

  /// Variables by the slots of the Names it was compiled with. The result may
  /// be NaN or infinite: the caller reports it with the inputs' values.
  double Evaluate(std::span<const double> variables) const {
    return constant_ ? *constant_ : Run(variables);
  }

  enum class Result { kNoText, kAny };
  /// Compiles `text`. On failure returns nothing and fills `error`.
  /// Operators, functions and units: docs/manual.md, "Expressions".
  static std::optional<Expression> Compile(std::string_view text, const Names& names, Error& error,
                                           Result result = Result::kNoText);

 private:
  Expression() = default;
  double Run(std::span<const double> variables) const;

  std::string text_;
  Type type_ = Type::kNumber;
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
