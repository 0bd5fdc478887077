#pragma once

#include <optional>
#include <string>

#include "mjforge/forge/forge.h"

namespace mjforge::app {

/// The variant must have an object; `sweep` is only there if it was requested.
std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant,
                        const std::optional<validate::Sweep>& sweep);

std::string InspectTables(const validate::CompiledModel& model,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const validate::CompiledModel& model,
                        const std::optional<validate::Sweep>& sweep);

}  // namespace mjforge::app
