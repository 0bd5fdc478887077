// Values that are the same in all variants, as JSON.
#pragma once

#include <optional>
#include <string>

namespace mjforge::spec {

struct Value;

/// Returns the options of a choice or a cycle as a JSON list. Returns nullopt for any other value,
/// and if an option is not a number, text, boolean or list of these that all variants share.
std::optional<std::string> ConstantChoices(const Value& value);

}  // namespace mjforge::spec
