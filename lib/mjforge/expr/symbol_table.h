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

/// Returns the number that represents a text among the variables of an expression: 52 bits of the
/// text's XXH64. Equal texts have equal numbers. Different texts practically always have different
/// numbers.
double TextKey(std::string_view text);

/// Names of the variables for the torque of a joint and the position of a site: "torque(shoulder)"
/// for torque(shoulder), "grip.pos" for the site `grip` in distance(grip, tip).
std::string TorqueVariable(std::string_view joint);
std::string PositionVariable(std::string_view site);

/// A function that a spec defines: an expression that uses the function's arguments (numbers) and
/// the names in scope. The function must not call itself, neither directly nor through other
/// functions.
struct SpecFunction {
  std::string name;
  std::vector<std::string> arguments;
  std::string body;
  diag::SourceMark mark = {};  // position of the body in the spec's text

  std::string Usage() const;  // "bulge(z)"
};

/// Symbol table: the names that an expression may use. A name has a slot, its index in the array of
/// variables that is passed to Evaluate(). A vector `v` of n components has n consecutive slots
/// (`v.x v.y v.z v.w`). Booleans are 0 and 1; texts are represented by their TextKey(). The slot of
/// a list contains the length of the list; a list also has a number, its index in the array of
/// lists. Slots are not reused after Forget().
class SymbolTable {
 public:
  struct Variable {
    std::string name;
    Type type = Type::kNumber;
    int slot = 0;
    int components = 1;
    int list = -1;  // index in the array of lists; -1: not a list
    Dimensions dimensions = {};

    bool is_list() const { return list >= 0; }
  };

  /// Declares a variable. The name must not be in scope yet.
  const Variable& Declare(const std::string& name, Type type, int components = 1,
                          Dimensions dimensions = {});
  /// Declares a list of any length.
  const Variable& DeclareList(const std::string& name, Type type, Dimensions dimensions = {});
  /// Declares a name whose members are unknown: NAME.MEMBER is a number for every MEMBER. Used
  /// after an error in the declaration of NAME, so that its uses are not reported as well.
  void DeclareUnknown(std::string name) { unknown_.insert(std::move(name)); }
  /// Ends the scope of a name, such as a loop's variable.
  void Forget(std::string_view name);
  /// Declares a name again after Forget(), with the slots that the name had.
  void Restore(const Variable& variable) { variables_.insert_or_assign(variable.name, variable); }
  const Variable* Find(std::string_view name) const;
  /// Adds a function. Replaces a function of the same name.
  void Define(const SpecFunction& function);
  const SpecFunction* FindFunction(std::string_view name) const;
  const std::map<std::string, SpecFunction, std::less<>>& functions() const { return functions_; }
  /// The variables in scope, sorted by name.
  std::vector<const Variable*> variables() const;
  int slot_count() const { return slot_count_; }
  int list_count() const { return list_count_; }

 private:
  std::map<std::string, Variable, std::less<>> variables_;
  std::map<std::string, SpecFunction, std::less<>> functions_;
  std::set<std::string, std::less<>> unknown_;
  Variable member_;  // returned for every member of an unknown name
  int slot_count_ = 0;
  int list_count_ = 0;
};

}  // namespace mjforge::expr
