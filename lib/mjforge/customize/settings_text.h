// Conversion of parameter settings to text: a shell command, and YAML for the option --params.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Returns YAML of a text. Adds quotes only if YAML would not read the text as a simple word.
std::string QuoteForYaml(std::string_view text);

/// Returns YAML that a spec reads as this text and not as an expression: `${'a + b'}` for "a + b".
std::string LiteralForYaml(std::string_view text);

/// A variant of a spec with settings.
struct VariantKey {
  std::uint64_t seed = 0;
  std::uint64_t index = 0;
  std::optional<std::uint64_t> place_seed = {};  // nullopt: it follows from `seed`
};

/// Returns the options of `mjforge inspect` that name a variant: "--seed 7 --index 0".
std::string OptionsText(const VariantKey& variant);
/// Returns the facts in a picture of the variant: "spec=hammer seed=7 index=0".
std::string FactsText(std::string_view spec, const VariantKey& variant);
/// Returns the command that makes `count` variants with these settings, from `variant` on. Several
/// variants are written to the folder `name`.
std::string CommandText(std::string_view spec, std::span<const spec::Setting> settings,
                        const VariantKey& variant, std::uint64_t count = 1,
                        std::string_view name = {});
/// Returns the settings as a YAML mapping, one per line.
std::string ParamsText(std::span<const spec::Setting> settings);

}  // namespace mjforge::customize
