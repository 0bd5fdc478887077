// Quoting of parameter settings for the shell and for YAML.

#include "mjforge/customize/settings_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mjforge/output/output.h"

namespace mjforge::customize {
namespace {

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
constexpr std::string_view kDigits = "0123456789";

bool ConsistsOf(std::string_view text, const std::string& characters) {
  return !text.empty() && text.find_first_not_of(characters) == text.npos;
}

// Returns true for words that YAML reads as booleans or null instead of texts.
bool IsYamlWord(std::string_view text) {
  constexpr std::array<std::string_view, 9> kWords = {"true", "false", "yes", "no", "on",
                                                      "off",  "null",  "y",   "n"};
  return std::ranges::find(kWords, diag::LowerCase(text)) != kWords.end();
}

}  // namespace

std::string QuoteForYaml(std::string_view text) {
  const bool is_word = ConsistsOf(text, fmt::format("{}{}", kLetters, kDigits)) &&
                       kLetters.find(text.front()) != kLetters.npos && !IsYamlWord(text);
  return is_word ? std::string(text) : spec::SingleQuoted(text);
}

std::string LiteralForYaml(std::string_view text) {
  // A text within an expression cannot contain ' or }, because expressions have no escapes. Writes
  // such a text after an expression for the empty text, which makes the whole value a text.
  constexpr std::string_view kOpen = "${";
  std::string value = "${''}";
  if (text.find_first_of("'}") == text.npos) {
    value = fmt::format("${{'{}'}}", text);
  } else {
    for (std::size_t i = 0; i < text.size(); ++i)
      value += text.substr(i).starts_with(kOpen) ? "${'$'}" : std::string(1, text[i]);
  }
  const std::string harmless = fmt::format("{}{} +-*/._=()<>", kLetters, kDigits);
  return text.find_first_not_of(harmless) == text.npos ? value : spec::SingleQuoted(value);
}

std::string OptionsText(const VariantKey& variant) {
  std::string text = fmt::format("--seed {} --index {}", variant.seed, variant.index);
  if (variant.place_seed) text += fmt::format(" --place-seed {}", *variant.place_seed);
  return text;
}

std::string FactsText(std::string_view spec, const VariantKey& variant) {
  std::string text = fmt::format("spec={} seed={} index={}", spec, variant.seed, variant.index);
  if (variant.place_seed) text += fmt::format(" place-seed={}", *variant.place_seed);
  return text;
}

std::string CommandText(std::string_view spec, std::span<const spec::Setting> settings,
                        const VariantKey& variant, std::uint64_t count, std::string_view name) {
  std::string command = "mjforge generate " + output::ShellWord(spec);
  if (variant.seed != 0) command += fmt::format(" --seed {}", variant.seed);
  if (variant.place_seed) command += fmt::format(" --place-seed {}", *variant.place_seed);
  if (variant.index != 0) command += fmt::format(" --first {}", variant.index);
  for (const spec::Setting& setting : settings)
    command += " --set " + output::ShellWord(setting.name + "=" + setting.text);
  if (count > 1) command += fmt::format(" -n {} -o {}/", count, output::ShellWord(name));
  return command;
}

std::string ParamsText(std::span<const spec::Setting> settings) {
  std::string text;
  for (const spec::Setting& setting : settings)
    text += fmt::format("{}: {}\n", setting.name, setting.text);
  return text.empty() ? "{}\n" : text;
}

}  // namespace mjforge::customize
