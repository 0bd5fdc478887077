// SymbolTable, the syntax of names, and lists of words.
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

bool IsAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

bool IsName(std::string_view text) {
  return !text.empty() && IsAsciiLetter(text.front()) && std::ranges::all_of(text, IsNameCharacter);
}

bool IsNameCharacter(char c) { return IsAsciiLetter(c) || IsDigit(c) || c == '_'; }

bool HasWord(std::string_view words, std::string_view word) {
  if (word.empty() || word.find(' ') != word.npos) return false;
  for (auto at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || words[at - 1] == ' ';
    if (begins && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

std::vector<std::string_view> WordsOf(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<std::string_view> words;
  for (auto begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(kBlanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::string_view TypeName(Type type) {
  constexpr std::string_view kNames[] = {"number", "boolean", "text"};  // in the order of Type
  return kNames[static_cast<std::size_t>(type)];
}

std::string TorqueVariable(std::string_view joint) { return fmt::format("torque({})", joint); }

std::string PositionVariable(std::string_view site) { return fmt::format("{}.pos", site); }

const SymbolTable::Variable& SymbolTable::Declare(const std::string& name, Type type,
                                                  int components, Dimensions dimensions) {
  const int slot = std::exchange(slot_count_, slot_count_ + components);
  const Variable variable{.name = name,
                          .type = type,
                          .slot = slot,
                          .components = components,
                          .dimensions = std::move(dimensions)};
  return variables_.insert_or_assign(name, variable).first->second;
}

const SymbolTable::Variable& SymbolTable::DeclareList(const std::string& name, Type type,
                                                      Dimensions dimensions) {
  const Variable list{.name = name,
                      .type = type,
                      .slot = slot_count_++,
                      .list = list_count_++,
                      .dimensions = std::move(dimensions)};
  return variables_.insert_or_assign(name, list).first->second;
}

void SymbolTable::Forget(std::string_view name) {
  const auto found = variables_.find(name);
  if (found != variables_.end()) variables_.erase(found);
}

const SymbolTable::Variable* SymbolTable::Find(std::string_view name) const {
  const auto found = variables_.find(name);
  if (found != variables_.end()) return &found->second;
  const std::size_t dot = name.find('.');
  return dot != name.npos && unknown_.contains(name.substr(0, dot)) ? &member_ : nullptr;
}

std::string SpecFunction::Usage() const {
  return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

void SymbolTable::Define(const SpecFunction& function) {
  functions_.insert_or_assign(function.name, function);
}

const SpecFunction* SymbolTable::FindFunction(std::string_view name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? nullptr : &found->second;
}

std::vector<const SymbolTable::Variable*> SymbolTable::variables() const {
  return diag::Mapped<const Variable*>(variables_, [](const auto& entry) { return &entry.second; });
}

}  // namespace mjforge::expr
