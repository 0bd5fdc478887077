// Conversion of parameter settings to text: a shell command, and YAML for the option --params.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Returns YAML of a text. Adds quotes only if YAML would not read the text as a simple word.
std::string QuoteForYaml(std::string_view text);

/// Returns YAML that a spec reads as this text and not as an expression: `${'a + b'}` for "a + b".
std::string LiteralForYaml(std::string_view text);

/// Returns the command that makes `count` variants with these settings, from `index` on. Several
/// variants are written to the folder `name`.
std::string CommandText(std::string_view spec, std::span<const spec::Setting> settings,
                        std::uint64_t seed, std::uint64_t index, std::uint64_t count = 1,
                        std::string_view name = {});
/// Returns the settings as a YAML mapping, one per line.
std::string ParamsText(std::span<const spec::Setting> settings);

}  // namespace mjforge::customize
