#include "child.h"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

namespace mjforge::app {
namespace {

// What both processes see.
struct Progress {
  std::size_t step = 0;  // being taken
  ExitStatus status = ExitStatus::kDone;
  bool done = false;
};

class SharedProgress {
 public:
  SharedProgress() {
    void* memory = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    progress_ = new (memory) Progress;
  }
  ~SharedProgress() { ::munmap(progress_, sizeof(Progress)); }
  SharedProgress(const SharedProgress&) = delete;
  SharedProgress& operator=(const SharedProgress&) = delete;

  Progress* operator->() const { return progress_; }

 private:
  Progress* progress_;
};

// Ends with the process that waits for it. Never returns.
[[noreturn]] void BeChild(std::size_t count, const std::function<ExitStatus(std::size_t)>& take,
                          const SharedProgress& progress, ::pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) std::_Exit(0);  // it ended before that
  try {
    for (; progress->step < count; ++progress->step)
      progress->status = Worse(progress->status, take(progress->step));
  } catch (const std::exception& error) {
    fmt::print(stderr, "mjforge: internal error: {}\n", error.what());
    progress->status = ExitStatus::kBug;
  }
  progress->done = true;
  std::exit(0);
}

// How a child ended, once it has. Whoever is asked to end by a signal of the terminal or of a
// batch system passes that on.
std::string WaitFor(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFSIGNALED(status)) return fmt::format("exit status {}", WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  return fmt::format("SIG{}", ::sigabbrev_np(signal));
}

}  // namespace

ExitStatus InChild(std::size_t count, const std::function<ExitStatus(std::size_t)>& take,
                   const std::function<ExitStatus(std::size_t, const std::string&)>& crashed) {
  const SharedProgress progress;
  while (progress->step < count && !progress->done) {
    std::fflush(nullptr);  // else both write what is waiting
    const ::pid_t parent = ::getpid();
    const ::pid_t child = ::fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot fork");
    if (child == 0) BeChild(count, take, progress, parent);
    const std::string end = WaitFor(child);
    if (progress->done) break;
    progress->status = Worse(progress->status, crashed(progress->step, end));
    ++progress->step;
  }
  return progress->status;
}

void AddCrash(const std::string& what, const std::string& end, diag::Findings& findings) {
  findings.Add(diag::Code::kMujocoError, {},
               fmt::format("MuJoCo crashed on '{}' ({})", what == "-" ? "<stdin>" : what, end),
               "see whether indices of meshes (`face`) are in range; a newer MuJoCo may say more");
}

ExitStatus InChild(const std::string& what, Console& console,
                   const std::function<ExitStatus()>& take) {
  return InChild(
      1, [&](std::size_t) { return take(); },
      [&](std::size_t, const std::string& end) {
        AddCrash(what, end, console.findings);
        return console.Tell();
      });
}

}  // namespace mjforge::app
