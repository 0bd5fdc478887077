// Rules for Make: targets, dependencies, and escaping of names.

#include <fmt/format.h>

#include "mjforge/output/output.h"

namespace mjforge::output {

std::string EscapeForMake(std::string_view name, bool is_target) {
  std::string text;
  std::size_t backslashes = 0;  // number of backslashes at the end of `text`
  for (const char c : name) {
    if (c == ' ' || c == '\t') {
      // Doubles the backslashes before an escaped blank, because Make halves them.
      text.append(backslashes + 1, '\\');
    } else if (c == '#' || c == ':' || (c == '%' && is_target)) {
      text += '\\';
    } else if (c == '$') {
      text += '$';
    }
    backslashes = c == '\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text;
}

bool FitsMake(std::string_view name) {
  return name.find_first_of(";=|\n\r") == name.npos && name.find("\\#") == name.npos;
}

std::string MakeRule(std::span<const std::string> targets, const std::set<std::string>& files,
                     bool phony) {
  std::string rule = fmt::format("{}:", fmt::join(targets, " "));
  for (const std::string& file : files) rule += " \\\n  " + EscapeForMake(file, false);
  rule += '\n';
  if (!phony) return rule;
  for (const std::string& file : files) rule += "\n" + EscapeForMake(file, true) + ":\n";
  return rule;
}

}  // namespace mjforge::output
