#include <algorithm>
#include <utility>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

std::string_view TypeName(Type type) {
  switch (type) {
    case Type::kNumber:
      return "number";
    case Type::kBoolean:
      return "boolean";
    case Type::kText:
      return "text";
  }
  return {};
}

int Names::Declare(std::string name, Type type, int components) {
  const int slot = slot_count_;
  slot_count_ += components;
  variables_.push_back({std::move(name), type, slot, components});
  return slot;
}

void Names::Forget(std::string_view name) {
  std::erase_if(variables_, [name](const Variable& variable) { return variable.name == name; });
}

const Names::Variable* Names::Find(std::string_view name) const {
  const auto found = std::find_if(variables_.begin(), variables_.end(),
                                  [name](const Variable& v) { return v.name == name; });
  return found == variables_.end() ? nullptr : &*found;
}

}  // namespace mjforge::expr
