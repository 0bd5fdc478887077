// Symbol table of an expression: variables with their slots, and functions of the spec.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/dimension.h"

namespace mjforge::expr {

enum class Type { kNumber, kBoolean, kText };
std::string_view TypeName(Type type);  // "number", "boolean", "text"

/// Returns the number that represents a text among an expression's variables: 52 bits of the text's
/// XXH64. Equal texts have equal numbers; different texts have different numbers in practice.
double TextKey(std::string_view text);

/// Returns the name of the variable that torque(shoulder) reads, "torque(shoulder)", or that
/// distance(grip, tip) reads for the site `grip`, "grip.pos".
std::string TorqueVariable(std::string_view joint);
std::string PositionVariable(std::string_view site);

/// A function that a spec defines: an expression of its arguments (numbers) and of the names in
/// scope. Must not call itself, directly or through other functions.
struct Formula {
  std::string name;
  std::vector<std::string> arguments;
  std::string body;
  diag::SourceMark mark = {};  // place of the body

  std::string Usage() const;  // "bulge(z)"
};

/// Symbol table: the names that an expression may use, and the slot of each in the array of
/// variables passed to Evaluate(). A vector `v` of n components fills n slots (`v.x v.y v.z v.w`);
/// booleans are 0 and 1; texts are TextKey()s. The slot of a list contains its length; the list
/// itself has a number among the lists. Slots are not reused after Forget().
class SymbolTable {
 public:
  struct Variable {
    std::string name;
    Type type = Type::kNumber;
    int slot = 0;
    int components = 1;
    int list = -1;  // -1: not a list
    Dimensions dimensions = {};

    bool is_list() const { return list >= 0; }
  };

  /// Declares a variable. The name must not be declared already.
  const Variable& Declare(const std::string& name, Type type, int components = 1,
                          Dimensions dimensions = {});
  /// Declares a list of any length.
  const Variable& DeclareList(const std::string& name, Type type, Dimensions dimensions = {});
  /// Declares a name with unknown members, so that NAME.MEMBER is a number for every MEMBER. Used
  /// to continue reading after a finding.
  void DeclareUnknown(std::string name) { unknown_.insert(std::move(name)); }
  /// Ends the scope of a name, such as a loop's variable.
  void Forget(std::string_view name);
  /// Declares a forgotten name again, with the slots that the name had.
  void Restore(const Variable& variable) { variables_.insert_or_assign(variable.name, variable); }
  const Variable* Find(std::string_view name) const;
  /// Adds a function, or replaces the function of that name.
  void Define(const Formula& formula);
  const Formula* FindFormula(std::string_view name) const;
  const std::map<std::string, Formula, std::less<>>& formulas() const { return formulas_; }
  /// The variables in scope, sorted by name.
  std::vector<const Variable*> variables() const;
  int slot_count() const { return slot_count_; }
  int list_count() const { return list_count_; }

 private:
  std::map<std::string, Variable, std::less<>> variables_;
  std::map<std::string, Formula, std::less<>> formulas_;
  std::set<std::string, std::less<>> unknown_;
  Variable member_;  // returned for every member of an unknown name
  int slot_count_ = 0;
  int list_count_ = 0;
};

}  // namespace mjforge::expr
