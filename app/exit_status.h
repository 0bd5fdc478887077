#ifndef MJFORGE_APP_EXIT_STATUS_H_
#define MJFORGE_APP_EXIT_STATUS_H_

#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// What the shell sees. Of several, the largest counts.
enum class ExitStatus {
  kDone = 0,
  kFindings = 1,       // a spec has errors, a variant failed
  kUsage = 2,          // wrong words on the command line
  kInputOutput = 3,    // reading or writing failed
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

}  // namespace mjforge::app

#endif  // MJFORGE_APP_EXIT_STATUS_H_
