// Output of results and findings to standard output and standard error, and the exit status.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::app {

using diag::Counted;
using Seconds = std::chrono::duration<double>;

/// Exit status of the program. If several apply, the largest is used.
enum class ExitStatus {
  kDone = 0,
  kFindings = 1,       // a spec has errors, a variant failed
  kUsage = 2,          // the command line is wrong
  kInputOutput = 3,    // reading or writing failed, or not enough memory
  kBug = 70,           // EX_SOFTWARE of sysexits.h
  kInterrupted = 130,  // 128 + SIGINT, like shells
  kNoReader = 141,     // 128 + SIGPIPE, like shells: the reader of standard output has ended
};

inline ExitStatus Worse(ExitStatus a, ExitStatus b) { return a < b ? b : a; }

inline ExitStatus StatusOf(const diag::Findings& findings) {
  ExitStatus status = ExitStatus::kDone;
  for (const diag::Finding& finding : findings) {
    if (finding.severity != diag::Severity::kError) continue;
    status = Worse(status, diag::IsInputOutput(finding.code) ? ExitStatus::kInputOutput
                                                             : ExitStatus::kFindings);
  }
  return status;
}

/// Options for the format of messages.
struct MessageOptions {
  std::string findings = "text";  // text, json
  std::string color = "auto";     // auto, always, never
  bool quiet = false;
};

/// Sources and findings of a command, and the output of messages to standard error. (Results go to
/// standard output: see Print.)
class Console {
 public:
  explicit Console(const MessageOptions& options);

  diag::Sources sources;
  diag::Findings findings;  // not yet reported

  /// Prints and clears `findings`; returns their exit status.
  ExitStatus Report();
  /// Prints the first 50 findings, in file order, and then the number of findings that were not
  /// printed plus `more`.
  void Show(diag::Findings found, const diag::Sources& places, std::uint64_t more = 0) const;
  /// Returns the text that Show prints.
  std::string TextOf(diag::Findings found, const diag::Sources& places,
                     std::uint64_t more = 0) const;
  /// Prints a line, unless --quiet was given. Control characters are escaped, because the line may
  /// contain text of unknown origin.
  void PrintLine(std::string_view line) const;
  bool quiet() const { return quiet_; }

 private:
  bool json_;
  bool color_;
  bool quiet_;
};

/// Returns true if an environment variable is set and not empty.
bool IsSet(const char* variable);

/// Returns true if standard error is a terminal with control sequences.
bool IsTerminal();

/// Returns a text of unknown origin as part of a line: line ends and tabs become spaces, and
/// characters that control a terminal are escaped.
std::string OneLine(std::string text);

/// Prints "mjforge: " and a message, which may contain text of unknown origin, to standard error.
void PrintError(std::string_view message);

/// Writes a result to be read on a terminal to standard output. Keeps line ends, and escapes other
/// characters that control a terminal, because names and descriptions may be of unknown origin. On
/// failure prints the reason and returns kInputOutput.
ExitStatus Print(std::string_view text);

/// Writes a result for programs (JSON, MJCF, pictures, pages), or without text of unknown origin,
/// to standard output without changing a byte. On failure prints the reason and returns
/// kInputOutput.
ExitStatus PrintBytes(std::string_view bytes);

}  // namespace mjforge::app
