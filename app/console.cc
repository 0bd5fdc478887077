// Writes results to standard output and findings to standard error, with colors, limits, escapes.
#include "console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "mjforge/batch/batch.h"

namespace mjforge::app {
namespace {

bool UseColor(const std::string& choice) {
  if (choice != "auto") return choice == "always";
  return !IsSet("NO_COLOR") && IsTerminal();  // https://no-color.org
}

}  // namespace

bool IsSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool IsTerminal() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) != 0 &&
         (terminal == nullptr || std::string_view(terminal) != "dumb");
}

Console::Console(const MessageOptions& options)
    : json_(options.findings == "json"), color_(UseColor(options.color)), quiet_(options.quiet) {}

ExitStatus Console::Report() {
  const ExitStatus status = StatusOf(findings);
  Show(std::exchange(findings, {}), sources);
  return status;
}

void Console::Show(diag::Findings found, const diag::Sources& places, std::uint64_t more) const {
  bytes::WriteAll(STDERR_FILENO, TextOf(std::move(found), places, more));
}

std::string Console::TextOf(diag::Findings found, const diag::Sources& places,
                            std::uint64_t more) const {
  found.Sort();
  found.Unique();
  std::string text;
  const std::size_t shown = std::min(found.size(), batch::kMaxFindings);
  for (std::size_t i = 0; i < shown; ++i) {
    text += json_ ? diag::RenderJson(found[i], places) + "\n"
                  : diag::RenderText(found[i], places, color_);
  }
  more += found.size() - shown;
  if (more > 0 && json_) text += fmt::format("{{\"more\":{}}}\n", more);
  if (more > 0 && !json_) text += fmt::format("and {} more\n", more);
  return text;
}

void Console::PrintLine(std::string_view line) const {
  if (!quiet_) bytes::WriteAll(STDERR_FILENO, diag::SafeText(line) + '\n');
}

std::string OneLine(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return diag::SafeText(text);
}

void PrintError(std::string_view message) {
  bytes::WriteAll(STDERR_FILENO, fmt::format("mjforge: {}\n", diag::SafeText(message)));
}

ExitStatus Print(std::string_view text) { return PrintBytes(diag::SafeLines(text)); }

ExitStatus PrintBytes(std::string_view bytes) {
  if (bytes::WriteAll(STDOUT_FILENO, bytes)) return ExitStatus::kDone;
  if (errno == EPIPE) return ExitStatus::kNoReader;  // silent, as in `mjforge catalogue | head`
  PrintError("error: cannot write to standard output: " + std::generic_category().message(errno));
  return ExitStatus::kInputOutput;
}

}  // namespace mjforge::app
