// Child processes with limits of CPU time, wall time and memory, and the reasons of their ends.
#include "child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <system_error>

#include "mjforge/batch/batch.h"
#include "usage.h"

namespace mjforge::app {
namespace {

constexpr std::string_view kNeedsMemory = "needs more memory than there is";

// Progress of the child process, in memory that the parent and the child share.
struct Progress {
  std::size_t step = 0;  // index of the current step
  ExitStatus status = ExitStatus::kDone;
  bool done = false;
};

// Limits the CPU time of the next step; SIGXCPU ends the process when the time is over.
void LimitTime(Seconds time) {
  struct rusage used;
  ::getrusage(RUSAGE_SELF, &used);
  const double end = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                     std::ceil(time.count()) + 1;
  const ::rlimit limit = {static_cast<::rlim_t>(end), RLIM_INFINITY};
  ::setrlimit(RLIMIT_CPU, &limit);
}

// Runs the remaining steps in the child process.
[[noreturn]] void RunSteps(std::size_t count, Seconds time_limit,
                           const std::function<ExitStatus(std::size_t)>& run_step,
                           Progress& progress) {
  LimitMemory();
  try {
    for (; progress.step < count; ++progress.step) {
      LimitTime(time_limit);
      progress.status = Worse(progress.status, run_step(progress.step));
    }
  } catch (const std::bad_alloc&) {
    static_assert(batch::kNoMemoryStatus == static_cast<int>(ExitStatus::kInputOutput));
    std::_Exit(batch::kNoMemoryStatus);
  } catch (const std::exception& error) {
    progress.status = Worse(progress.status, ExplainException(error));
  }
  progress.done = true;
  std::exit(0);
}

// Waits for the end of the child, which closes the write end of the child's pipe; returns false if
// the child is still running after `time`.
bool HasEnded(int pipe, Seconds time) {
  ::pollfd polled = {pipe, POLLIN, 0};
  int ready = 0;
  // Polls in short intervals, so that time in which both processes were stopped (Ctrl-Z) is not
  // counted.
  constexpr int kTurnMilliseconds = 1000;
  for (double left = time.count() * 1000; left > 0 && ready <= 0; left -= kTurnMilliseconds)
    ready =
        ::poll(&polled, 1, std::min(static_cast<int>(std::min(left, 1e9)) + 1, kTurnMilliseconds));
  return ready > 0;
}

// Waits for the child and returns the reason of the child's end. Kills the child if a step exceeds
// its wall time. If a signal of the terminal or of a batch system ended the child, ends this
// process by the same signal.
std::string WaitFor(::pid_t child, int pipe, Seconds time_limit, const Progress& progress) {
  const Seconds patience = batch::WallLimit(time_limit);
  std::size_t step = progress.step;
  while (!HasEnded(pipe, patience)) {
    const std::size_t now = progress.step;
    if (now == step) {
      ::kill(child, SIGKILL);
      batch::WaitForEnd(child);
      return fmt::format("took more than {:g} s of wall time", patience.count());
    }
    step = now;
  }
  const int status = batch::WaitForEnd(child);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return fmt::format("took more than {:g} s of CPU time", time_limit.count());
  batch::EndBySignalOf(status);
  return DescribeEnd(status);
}

}  // namespace

std::string DescribeEnd(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("made MuJoCo crash (SIG{})", ::sigabbrev_np(WTERMSIG(status)));
  return WEXITSTATUS(status) == batch::kNoMemoryStatus
             ? std::string(kNeedsMemory)
             : fmt::format("made MuJoCo end the process with status {}", WEXITSTATUS(status));
}

// Does nothing under AddressSanitizer, which reserves terabytes of address space.
void LimitMemory() {
#ifndef __SANITIZE_ADDRESS__
  constexpr ::rlim_t kMost = ::rlim_t{8} << 30;
  const ::rlimit limit = {kMost, kMost};
  ::setrlimit(RLIMIT_DATA, &limit);
#endif
}

ExitStatus RunInChild(std::size_t count, Seconds time_limit,
                      const std::function<ExitStatus(std::size_t)>& run_step,
                      const std::function<ExitStatus(std::size_t, const std::string&)>& crashed) {
  const std::shared_ptr<Progress> progress = batch::Share<Progress>();
  while (progress->step < count && !progress->done) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
    const ::pid_t child = batch::Fork("cannot fork");
    if (child == 0) RunSteps(count, time_limit, run_step, *progress);
    ::close(ends[1]);
    const std::string reason = WaitFor(child, ends[0], time_limit, *progress);
    ::close(ends[0]);
    if (progress->done) break;
    progress->status = Worse(progress->status, crashed(progress->step, reason));
    if (reason == kNeedsMemory)
      progress->status = Worse(progress->status, ExitStatus::kInputOutput);
    ++progress->step;
  }
  return progress->status;
}

void AddCrashFinding(const std::string& what, const std::string& reason, diag::Findings& findings) {
  findings.Add(diag::Code::kMujocoError, {},
               fmt::format("'{}' {}", what == "-" ? "<stdin>" : what, reason),
               reason.starts_with("took") ? "raise --time-limit"
               : reason == kNeedsMemory   ? "8 GiB are the most; `ulimit -v` may set a lower limit"
                                          : "see whether sizes and counts are sensible; a newer "
                                            "MuJoCo may say more");
}

void EndWithParent() {
  const char* const parent = std::getenv("MJFORGE_PARENT");
  if (parent == nullptr) return;
  batch::EndWith(static_cast<::pid_t>(output::ReadIndex(parent).value_or(0)), SIGTERM);
  ::unsetenv("MJFORGE_PARENT");
}

ExitStatus RunInChild(const std::string& what, Seconds time_limit, Console& console,
                      const std::function<ExitStatus()>& run) {
  return RunInChild(
      1, time_limit, [&](std::size_t) { return run(); },
      [&](std::size_t, const std::string& reason) {
        AddCrashFinding(what, reason, console.findings);
        return console.Report();
      });
}

}  // namespace mjforge::app
