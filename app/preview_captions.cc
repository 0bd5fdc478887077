// Captions of the variants on a contact sheet: choice and format of the parameters.
#include "preview_captions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "mjforge/expr/expr.h"

namespace mjforge::app {
namespace {

using manifest::Record;
using sample::ParameterValue;

constexpr std::size_t kMaxParameters = 4;
constexpr int kMaxLetters = 36;       // letters of a line; longer ones are hard to read
constexpr double kLetterWidth = 6.5;  // pixels of a letter, on average and rounded up

// Last words of parameter names that captions leave out, because the value implies them: a caption
// has "steel" for a parameter `material` with this value.
constexpr std::array<std::string_view, 15> kEmptyWords = {
    "color", "colour", "finish", "kind", "look",  "make", "material", "metal",
    "model", "name",   "shape",  "size", "style", "type", "wood"};
// Words in the names of parameters whose values a picture does not show, even if they have no unit.
constexpr std::array<std::string_view, 9> kUnseen = {"armature", "clearance", "damping",
                                                     "density",  "friction",  "margin",
                                                     "mass",     "play",      "stiffness"};
// Prefixes of the names of counts and yes-no questions.
constexpr std::array<std::string_view, 6> kPrefixes = {"number of ", "count of ", "n ",
                                                       "has ",       "with ",     "is "};

std::string WithSpaces(std::string_view text) {
  std::string words(text);
  std::ranges::replace_if(
      words, [](char c) { return c == '_' || c == '.'; }, ' ');
  return words;
}

// Returns the noun in a parameter's name: "handle" for "handle_shape" and for "has_handle".
std::string NounOf(std::string_view name) {
  std::string words = WithSpaces(name);
  for (const std::string_view prefix : kPrefixes) {
    if (words.starts_with(prefix)) words.erase(0, prefix.size());
  }
  for (std::size_t space = words.rfind(' ');; space = words.rfind(' ')) {
    const std::string last = words.substr(space == words.npos ? 0 : space + 1);
    if (std::ranges::find(kEmptyWords, last) == kEmptyWords.end()) return words;
    if (space == words.npos) return "";
    words.erase(space);
  }
}

// Returns the SI unit of a parameter's numbers, or an empty text. If the spec declares no unit, the
// unit is inferred from the text of the value: "m" from "22cm .. 30cm".
std::string_view UnitOf(const spec::Parameter* parameter) {
  if (parameter == nullptr) return "";
  if (parameter->unit == "1") return "";
  if (!parameter->unit.empty()) return parameter->unit;
  const std::string& text = parameter->source;
  for (const auto& [unit, si] :
       {std::pair("mm", "m"), std::pair("cm", "m"), std::pair("deg", "rad")}) {
    for (std::size_t at = text.find(unit); at != text.npos; at = text.find(unit, at + 1)) {
      if (at > 0 && expr::IsDigit(text[at - 1])) return si;
    }
  }
  return "";
}

// Returns a number with two digits, or with all digits before the point: "28", "0.75", "1500".
std::string ShortNumber(double number) {
  return std::abs(number) >= 10 ? fmt::format("{:.0f}", number) : fmt::format("{:.2g}", number);
}

// Returns a number with its unit: "28 cm", "45 deg".
std::string NumberText(double number, std::string_view unit) {
  const double size = std::abs(number);
  if (unit == "rad") return ShortNumber(number * 180 / std::numbers::pi) + " deg";
  if (unit == "m" && size > 0 && size < 0.01) return ShortNumber(1000 * number) + " mm";
  if (unit == "m" && size > 0 && size < 1) return ShortNumber(100 * number) + " cm";
  if (unit == "m") return fmt::format("{:.2g} m", number);
  return ShortNumber(number);
}

std::string WordText(const std::string& noun, const std::string& value) {
  std::string words = WithSpaces(value);
  if (noun.empty() || words == noun) return words;
  return (words == "none" ? "no" : words) + " " + noun;
}

bool IsWhole(const ParameterValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr && *number == std::floor(*number) && std::abs(*number) < 1e6;
}

// Returns the text of a value: "steel handle", "no lid", "7 spokes", "handle length 28 cm".
std::string TextOf(const std::string& name, const ParameterValue& value, std::string_view unit,
                   bool is_count) {
  const std::string noun = NounOf(name);
  if (const auto* boolean = std::get_if<bool>(&value)) {
    const bool is_adjective = name.starts_with("is_") || name.ends_with("ed");
    const char* no = is_adjective ? "not " : "no ";
    return *boolean ? noun : no + noun;
  }
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr) return WordText(noun, std::get<std::string>(value));
  if (is_count) return fmt::format("{:.0f} {}", *number, noun);
  return WithSpaces(name) + " " + NumberText(*number, unit);
}

bool IsSeen(std::string_view name, std::string_view unit) {
  if (!unit.empty() && unit != "m" && unit != "rad") return false;
  return std::ranges::none_of(kUnseen, [&](std::string_view word) {
    const std::size_t at = name.find(word);
    if (at == name.npos) return false;
    const std::size_t end = at + word.size();
    return (at == 0 || name[at - 1] == '_') && (end == name.size() || name[end] == '_');
  });
}

// Visibility of the differences between variants in one parameter. Captions show low ranks first: 0
// for words, 1 for counts, 2 for lengths, 3 for angles, 4 for other numbers without a unit. Lists
// are too long for captions and have no spread.
struct Difference {
  int rank = 0;
  double spread = 0;  // orders parameters of one rank; 0: no difference is visible in a picture
};
constexpr int kCount = 1;

Difference DifferenceOf(std::span<const Record> records, std::size_t parameter,
                        std::string_view unit) {
  const std::string& name = records.front().params[parameter].first;
  if (!IsSeen(name, unit)) return {};
  std::set<std::string> texts;
  std::vector<double> numbers;
  bool is_count = unit.empty();
  for (const Record& record : records) {
    const ParameterValue& value = record.params[parameter].second;
    if (std::holds_alternative<std::vector<double>>(value) ||
        std::holds_alternative<std::vector<std::string>>(value) ||
        std::holds_alternative<std::vector<bool>>(value)) {
      return {};
    }
    is_count = is_count && IsWhole(value);
    texts.insert(TextOf(name, value, unit, false));
    if (const auto* number = std::get_if<double>(&value)) numbers.push_back(*number);
  }
  if (texts.size() < 2) return {};
  if (numbers.size() < records.size())
    return {0, static_cast<double>(texts.size()) / static_cast<double>(records.size())};
  const auto [min, max] = std::minmax_element(numbers.begin(), numbers.end());
  const double width = *max - *min;
  if (unit == "m") return {2, width};
  if (unit == "rad") return {3, width};
  return {is_count ? kCount : 4, width / std::max(std::abs(*max), std::abs(*min))};
}

// Returns true for drawn parameters; false if the value is computed from others or looked up in a
// table.
bool IsDrawn(const spec::ObjectSpec& spec, const std::string& name) {
  const spec::Parameter* parameter = spec.FindParameter(name);
  if (parameter == nullptr) return false;
  const auto* draw = std::get_if<spec::Draw>(&spec.ValueOf(*parameter).form);
  return draw != nullptr && draw->rows == nullptr;
}

// Returns the parameters with the most visible differences, as (rank, -spread, index).
std::vector<std::tuple<int, double, std::size_t>> MostDifferent(std::span<const Record> records,
                                                                const spec::ObjectSpec& spec) {
  const auto& params = records.front().params;
  const bool any_drawn = std::any_of(params.begin(), params.end(),
                                     [&](const auto& param) { return IsDrawn(spec, param.first); });
  std::vector<std::tuple<int, double, std::size_t>> found;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (any_drawn && !IsDrawn(spec, params[i].first)) continue;
    const auto [rank, spread] =
        DifferenceOf(records, i, UnitOf(spec.FindParameter(params[i].first)));
    if (spread > 0) found.emplace_back(rank, -spread, i);
  }
  std::ranges::sort(found);
  found.resize(std::min(found.size(), kMaxParameters));
  return found;
}

// Adds an item to the last line, or begins another line: after the first line (the variant's
// index), and if the last line would have more than `most` letters.
void AddItem(const std::string& item, std::size_t most, std::vector<std::string>& lines) {
  if (lines.size() > 1 && lines.back().size() + 2 + item.size() <= most) {
    lines.back() += ", " + item;
  } else {
    lines.push_back(item);
  }
}

}  // namespace

std::vector<std::vector<std::string>> MakeCaptions(std::span<const Record> records,
                                                   const spec::ObjectSpec& spec, int width) {
  std::vector<std::vector<std::string>> captions;
  if (records.empty()) return captions;
  const auto most =
      static_cast<std::size_t>(std::min(kMaxLetters, static_cast<int>(width / kLetterWidth)));
  const auto parameters = MostDifferent(records, spec);
  for (const Record& record : records) {
    std::vector<std::string>& lines = captions.emplace_back();
    lines.push_back(fmt::format("#{}", record.index));
    for (const auto& [rank, spread, parameter] : parameters) {
      const auto& [name, value] = record.params[parameter];
      AddItem(TextOf(name, value, UnitOf(spec.FindParameter(name)), rank == kCount), most, lines);
    }
  }
  return captions;
}

}  // namespace mjforge::app
