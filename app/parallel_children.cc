// Running untrusted work in several child processes at a time.
#include "parallel_children.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "child_process.h"

namespace mjforge::app {
namespace {

// Size limit of a message in bytes; the kernel accepts longer messages by default.
constexpr std::size_t kMaxMessage = 160'000;

// Index of the next step, in memory that all processes share.
using Counter = std::atomic<std::size_t>;

std::shared_ptr<Counter> ShareCounters(std::size_t count) {
  const std::size_t size = count * sizeof(Counter);
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  auto* counters = static_cast<Counter*>(memory);
  for (std::size_t i = 0; i < count; ++i) new (counters + i) Counter(0);
  return {counters, [size](Counter* first) { ::munmap(first, size); }};
}

[[noreturn]] void Throw(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// Sends the number of a step and its result as one message.
void Send(int socket, std::size_t step, const std::string& result) {
  std::string message(sizeof step, '\0');
  std::memcpy(message.data(), &step, sizeof step);
  message.append(result, 0, kMaxMessage - sizeof step);
  while (::send(socket, message.data(), message.size(), MSG_NOSIGNAL) < 0) {
    if (errno != EINTR) Throw("cannot send a result");
  }
}

// Runs steps until none is left. `current` is the running step, shared with child processes.
ExitStatus RunSome(const ParallelSteps& steps, int socket, Counter& next, Counter& current) {
  return RunInChild(
      steps.count, steps.time_limit,
      [&](std::size_t) {
        const std::size_t step = next.fetch_add(1);
        if (step >= steps.count) return ExitStatus::kDone;
        current = step;
        Send(socket, step, steps.run(step));
        return ExitStatus::kDone;
      },
      [&](std::size_t, const std::string& reason) {
        Send(socket, current, steps.explain(current, reason));
        return ExitStatus::kDone;
      });
}

// Takes messages until all processes that can send messages have ended.
void TakeResults(const ParallelSteps& steps, int socket) {
  std::vector<char> message(kMaxMessage);
  while (true) {
    const ::ssize_t size = ::recv(socket, message.data(), message.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size < static_cast<::ssize_t>(sizeof(std::size_t))) return;
    std::size_t step = 0;
    std::memcpy(&step, message.data(), sizeof step);
    steps.receive(step, std::string(message.data() + sizeof step,
                                    static_cast<std::size_t>(size) - sizeof step));
  }
}

// Returns the exit status of a child. If a user ended the child by a signal, ends this process by
// the same signal.
ExitStatus WaitForEnd(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) return static_cast<ExitStatus>(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  return ExitStatus::kBug;
}

}  // namespace

ExitStatus RunInChildren(const ParallelSteps& steps, std::uint64_t jobs) {
  if (jobs == 0) jobs = std::max(1U, std::thread::hardware_concurrency());
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(jobs, steps.count));
  const std::shared_ptr<Counter> counters = ShareCounters(1 + count);
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
    Throw("cannot make a socket");
  std::vector<::pid_t> children;
  const ::pid_t parent = ::getpid();
  std::fflush(nullptr);
  for (std::size_t i = 0; i < count; ++i) {
    const ::pid_t child = ::fork();
    if (child < 0) Throw("cannot fork");
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      if (::getppid() != parent) std::_Exit(0);  // the parent ended before prctl
      ::close(ends[0]);
      std::_Exit(
          static_cast<int>(RunSome(steps, ends[1], counters.get()[0], counters.get()[1 + i])));
    }
    children.push_back(child);
  }
  ::close(ends[1]);
  TakeResults(steps, ends[0]);
  ::close(ends[0]);
  ExitStatus status = ExitStatus::kDone;
  for (const ::pid_t child : children) status = Worse(status, WaitForEnd(child));
  return status;
}

}  // namespace mjforge::app
