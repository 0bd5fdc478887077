// Options of a choice or a cycle as JSON text, if the options are the same in all variants.
#pragma once

#include <optional>
#include <string>

namespace mjforge::spec {

struct Value;

/// Returns the options of a choice or a cycle as a JSON list. Returns nullopt for any other value,
/// and if an option can differ between variants.
std::optional<std::string> ConstantChoices(const Value& value);

}  // namespace mjforge::spec
