// Limit of the CPU time for loading a spec.
#include "load_time_limit.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>

namespace mjforge::app {
namespace {

// Message of the signal handler, prepared because the handler cannot allocate memory.
std::string limit_message;

extern "C" void OnLimit(int) {
  [[maybe_unused]] const ssize_t written =
      ::write(STDERR_FILENO, limit_message.data(), limit_message.size());
  ::_exit(static_cast<int>(ExitStatus::kFindings));
}

// Sets the timer of the process's CPU time; 0 stops it.
void SetTimer(double seconds) {
  ::itimerval timer = {};
  timer.it_value.tv_sec = static_cast<::time_t>(seconds);
  timer.it_value.tv_usec =
      static_cast<::suseconds_t>((seconds - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  if (seconds > 0 && timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0)
    timer.it_value.tv_usec = 1;
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

LoadTimeLimit::LoadTimeLimit(const std::string& what, Seconds limit, const Console& console) {
  diag::Findings findings;
  findings.Add(diag::Code::kBatchTooSlow, {},
               fmt::format("loading '{}' took more than {:g} s of CPU time", what, limit.count()),
               "raise --time-limit, or see what the spec and what it imports have so much of");
  limit_message = console.TextOf(std::move(findings), {});
  std::signal(SIGPROF, OnLimit);
  SetTimer(limit.count());
}

LoadTimeLimit::~LoadTimeLimit() {
  SetTimer(0);
  std::signal(SIGPROF, SIG_DFL);
}

}  // namespace mjforge::app
