#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// What the shell sees. Of several, the largest counts.
enum class ExitStatus {
  kDone = 0,
  kFindings = 1,       // a spec has errors, a variant failed
  kUsage = 2,          // wrong words on the command line
  kInputOutput = 3,    // reading or writing failed, memory is short
  kBug = 70,           // sysexits.h: EX_SOFTWARE
  kInterrupted = 130,  // 128 + SIGINT, as shells count
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

/// How to speak.
struct ReportOptions {
  std::string findings = "text";  // text json
  std::string color = "auto";     // auto always never
  bool quiet = false;
};

/// What a command has read and found, and where it reports it. Results go to standard output,
/// messages to standard error.
class Console {
 public:
  explicit Console(const ReportOptions& options);

  diag::Sources sources;
  diag::Findings findings;  // not shown yet

  /// Shows `findings` and clears them; returns the exit status that they call for.
  ExitStatus Tell();
  /// Findings in file order, the first 50; `more` were left out before.
  void Show(diag::Findings found, const diag::Sources& places, std::uint64_t more = 0) const;
  /// What Show writes.
  std::string TextOf(diag::Findings found, const diag::Sources& places,
                     std::uint64_t more = 0) const;
  /// One line of words; not with --quiet.
  void Say(std::string_view line) const;
  bool quiet() const { return quiet_; }

 private:
  bool json_;
  bool color_;
  bool quiet_;
};

/// Whether a variable of the environment has a value that is not empty.
bool IsSet(const char* variable);

/// Whether standard error is a terminal that understands control sequences.
bool IsTerminal();

/// Writes a result to standard output at once. On failure says why:
/// kInputOutput, else kDone.
ExitStatus Print(std::string_view bytes);

}  // namespace mjforge::app
