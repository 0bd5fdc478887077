#ifndef MJFORGE_APP_CONSOLE_H_
#define MJFORGE_APP_CONSOLE_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "exit_status.h"
#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// How to speak.
struct ReportOptions {
  std::string findings = "text";  // text json
  std::string color = "auto";     // auto always never
  bool quiet = false;
  bool verbose = false;
};

/// Results go to standard output, words to standard error.
class Console {
 public:
  explicit Console(const ReportOptions& options);

  /// Findings in file order, the first 50; `more` were left out before.
  void Show(diag::Findings findings, const diag::Sources& sources, std::uint64_t more = 0);
  /// One line of words; not with --quiet.
  void Say(std::string_view line);
  bool verbose() const { return verbose_; }

 private:
  bool json_;
  bool color_;
  bool quiet_;
  bool verbose_;
};

/// Whether standard error is a terminal that understands control sequences.
bool IsTerminal();

/// Writes a result to standard output at once. On failure says why:
/// kInputOutput, else kDone.
ExitStatus Print(std::string_view bytes);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_CONSOLE_H_
