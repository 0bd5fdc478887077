#pragma once

// Private to the room: what the words of an expression stand for, as operands of its program.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mjforge/expr/cursor.h"
#include "mjforge/expr/grammar.h"

namespace mjforge::expr {

class Operands : protected Cursor {
 protected:
  using Result = std::optional<Typed>;  // nothing after an error
  using Arguments = std::map<std::string_view, Typed>;

  Operands(std::string_view text, std::vector<Word> words, Parts& parts, Arguments arguments);

  Result Fail(Error error);
  Result FailText(const Typed& operand);

  /// Of the word just taken.
  Typed Literal(double value, Type type, Dimension dimension = {}) const;
  Typed Quoted(const Word& word);
  /// What a function gives. `offset`: of its name or sign, where it is told if the units of the
  /// arguments do not fit.
  Result Applied(const Callee& callee, Type type, std::span<const Argument> arguments,
                 std::size_t offset);
  /// The value of the name just taken. `beside_text`: it is compared with a text.
  Result Named(const Word& word, bool beside_text);

  /// Whether the word names a list or a vector.
  bool IsListAt(std::size_t word) const;
  Result ElementOf(const Word& list, const Argument& argument);
  /// What a function of lists gives for the one that a word names; `count`: of its first ones, null
  /// for all.
  Result OfList(const ListCallee& callee, std::size_t word, const Argument* count);

  const Names& names_;
  Parsed& parsed_;
  Error& error_;

 private:
  Result Component(const Word& word, const Names::Variable& vector, std::string_view component);
  Typed Input(const Word& word, const Names::Variable& variable, int component);
  ListSource AsList(const Names::Variable& variable);
  void NoteItem(const Names::Variable& variable, int item);
  void NoteInput(std::string_view name, const Names::Variable& variable, int slot);

  Arguments arguments_;  // of the function whose body this is
};

}  // namespace mjforge::expr
