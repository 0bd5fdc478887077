// Values that are the same in all variants, as JSON.
#pragma once

#include <optional>
#include <string>

namespace mjforge::spec {

struct Value;

/// Returns the options of a choice or a cycle as a JSON list. Returns nullopt for any other value,
/// and if an option is not the same in all variants (a number, text or boolean, or a list of
/// these).
std::optional<std::string> ConstantChoices(const Value& value);

}  // namespace mjforge::spec
