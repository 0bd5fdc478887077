// Conversion of parameter values to text: a shell command, and YAML for --params.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Returns a text as YAML that is read as that text, with quotes only if they are needed.
std::string QuoteForYaml(std::string_view text);

/// Returns YAML of an expression whose value is the text: `${'a + b'}` for the text "a + b".
std::string LiteralForYaml(std::string_view text);

/// Returns the command that makes `count` variants with these settings, from `index` on. Several
/// variants are written to the folder `name`.
std::string CommandText(std::string_view spec, std::span<const spec::Setting> settings,
                        std::uint64_t seed, std::uint64_t index, std::uint64_t count = 1,
                        std::string_view name = {});
/// Returns the settings as a YAML mapping, one per line.
std::string ParamsText(std::span<const spec::Setting> settings);

}  // namespace mjforge::customize
