// Finds the reason, the line, and the XML element of an error message of MuJoCo.
#include "mjforge/engine/mujoco_error.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include <fmt/format.h>

namespace mjforge::engine {
namespace {

// Words before the line number in messages of MuJoCo's compiler (the first entry up to 2.3, the
// second from 3.0 on), MuJoCo's XML reader, and tinyxml2.
constexpr std::string_view kLineWords[] = {", line = ", ", line ", "', line ",
                                           "Line number=", "on line "};
constexpr std::string_view kPrefixes[] = {"XML Error: ", "Error: ", "XML parse error "};

int LineOf(std::string_view message) {
  for (const std::string_view word : kLineWords) {
    const std::size_t at = message.rfind(word);
    if (at == std::string_view::npos) continue;
    const std::string_view rest = message.substr(at + word.size());
    int line = 0;
    const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), line);
    if (result.ec == std::errc() && line > 0) return line;
  }
  return 0;
}

// Returns the line of the sensor with the name that a message ends with: "Object name = NAME, id =
// 1". Returns 0 if there is none.
int LineOfSensor(std::string_view message, std::string_view xml) {
  constexpr std::string_view kStart = "\nObject name = ";
  const std::size_t start = message.rfind(kStart);
  if (start == std::string_view::npos || message.find("in sensor") == std::string_view::npos)
    return 0;
  const std::string_view rest = message.substr(start + kStart.size());
  const std::string_view name = rest.substr(0, rest.rfind(", id"));
  if (name.empty()) return 0;
  for (std::size_t begin = xml.find("<sensor>"); begin != std::string_view::npos;
       begin = xml.find("<sensor>", begin + 1)) {
    const std::size_t end = std::min(xml.find("</sensor>", begin), xml.size());
    for (const char quote : {'"', '\''}) {
      const std::size_t at =
          xml.substr(0, end).find(fmt::format(" name={0}{1}{0}", quote, name), begin);
      if (at != std::string_view::npos)
        return 1 + static_cast<int>(std::ranges::count(xml.substr(0, at), '\n'));
    }
  }
  return 0;
}

std::string_view LineText(std::string_view text, int line) {
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

}  // namespace

std::string OneLine(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool blank = static_cast<unsigned char>(c) <= ' ';
    if (!blank) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (line.ends_with(' ') || line.ends_with('.')) line.pop_back();
  return line;
}

Refusal ParseRefusal(std::string_view message, std::string_view xml) {
  Refusal refusal;
  refusal.line = LineOf(message);
  if (refusal.line == 0) refusal.line = LineOfSensor(message, xml);
  std::string_view reason = message;
  for (const std::string_view prefix : kPrefixes) {
    if (reason.starts_with(prefix)) reason.remove_prefix(prefix.size());
  }
  // Omits the last line of the message, which names the element.
  const std::size_t where = std::min(reason.rfind("\nObject name"), reason.rfind("\nElement "));
  refusal.reason = OneLine(reason.substr(0, where));
  return refusal;
}

std::string ElementOnLine(std::string_view xml, int line) {
  const std::string_view text = line > 0 ? LineText(xml, line) : std::string_view();
  const std::size_t start = text.find('<');
  if (start == std::string_view::npos) return "the model";
  const std::string_view element = text.substr(start + 1);
  const std::string_view tag = element.substr(0, element.find_first_of(" />\t\r"));
  constexpr std::string_view kName = " name=\"";
  const std::size_t name = element.find(kName);
  if (name == std::string_view::npos) return fmt::format("the {} on line {}", tag, line);
  const std::string_view value = element.substr(name + kName.size());
  return fmt::format("{} '{}'", tag, value.substr(0, value.find('"')));
}

}  // namespace mjforge::engine
