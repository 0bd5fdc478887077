// Limits of CPU time and wall time for loading a spec: timers and signal handlers.
#include "load_time_limit.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "mjforge/batch/batch.h"

namespace mjforge::app {
namespace {

// Messages of the signal handlers, prepared because a handler cannot allocate memory.
std::string cpu_time_message;
std::string wall_time_message;
volatile std::sig_atomic_t wall_seconds_left = 0;

void End(const std::string& message) {
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(static_cast<int>(ExitStatus::kFindings));
}

extern "C" void OnCpuTimeLimit(int) { End(cpu_time_message); }

// Counts one second of wall time. While the process is stopped (Ctrl-Z), at most one second counts.
extern "C" void OnSecond(int) {
  wall_seconds_left = wall_seconds_left - 1;
  if (wall_seconds_left <= 0) End(wall_time_message);
}

// Sets a timer of the process that expires after `first` seconds, and then every `interval` seconds
// (0: only once). The timer is stopped if `first` is 0.
void SetTimer(decltype(ITIMER_REAL) which, double first, ::time_t interval) {
  ::itimerval timer = {};
  timer.it_interval.tv_sec = interval;
  timer.it_value.tv_sec = static_cast<::time_t>(first);
  timer.it_value.tv_usec =
      static_cast<::suseconds_t>((first - static_cast<double>(timer.it_value.tv_sec)) * 1e6);
  if (first > 0 && timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0)
    timer.it_value.tv_usec = 1;
  ::setitimer(which, &timer, nullptr);
}

std::string MessageOf(const std::string& what, Seconds limit, std::string_view kind,
                      const Console& console) {
  diag::Findings findings;
  findings.Add(
      diag::Code::kBatchTooSlow, {},
      fmt::format("loading '{}' took more than {:g} s of {} time", what, limit.count(), kind),
      "raise --time-limit, or see what the spec and what it imports have so much of");
  return console.TextOf(std::move(findings), {});
}

}  // namespace

LoadTimeLimit::LoadTimeLimit(const std::string& what, Seconds limit, const Console& console) {
  constexpr double kMostSeconds = 1e9;
  const Seconds wall_limit = batch::WallLimit(limit);
  cpu_time_message = MessageOf(what, limit, "CPU", console);
  wall_time_message = MessageOf(what, wall_limit, "wall", console);
  wall_seconds_left =
      static_cast<std::sig_atomic_t>(std::min(std::ceil(wall_limit.count()), kMostSeconds));
  std::signal(SIGPROF, OnCpuTimeLimit);
  std::signal(SIGALRM, OnSecond);
  SetTimer(ITIMER_PROF, limit.count(), 0);
  SetTimer(ITIMER_REAL, 1, 1);
}

LoadTimeLimit::~LoadTimeLimit() {
  SetTimer(ITIMER_PROF, 0, 0);
  SetTimer(ITIMER_REAL, 0, 0);
  std::signal(SIGPROF, SIG_DFL);
  std::signal(SIGALRM, SIG_DFL);
}

}  // namespace mjforge::app
