// Several child processes that share a counter of steps and send their results to the parent.
#include "parallel_children.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

#include "child_process.h"
#include "mjforge/batch/batch.h"

namespace mjforge::app {
namespace {

// Size limit of a message in bytes. Linux accepts longer messages by default, so a send does not
// fail because of the size.
constexpr std::size_t kMaxMessage = 160'000;

// Index of the next step, in memory that all processes share.
using Counter = std::atomic<std::size_t>;

// Sends the number of a step and its result as one message.
void Send(int socket, std::size_t step, const std::string& result) {
  std::string message(sizeof step, '\0');
  std::memcpy(message.data(), &step, sizeof step);
  message.append(result, 0, kMaxMessage - sizeof step);
  while (::send(socket, message.data(), message.size(), MSG_NOSIGNAL) < 0) {
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "cannot send a result");
  }
}

// Runs steps in child processes until none is left. `current` is the index of the running step, in
// memory that the child processes share.
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

// Waits for a child and returns its exit status.
ExitStatus StatusOfChild(::pid_t child) {
  const int status = batch::WaitForEnd(child);
  batch::EndBySignalOf(status);
  return WIFEXITED(status) ? static_cast<ExitStatus>(WEXITSTATUS(status)) : ExitStatus::kBug;
}

}  // namespace

ExitStatus RunInChildren(const ParallelSteps& steps, std::uint64_t jobs) {
  if (jobs == 0) jobs = std::max(1U, std::thread::hardware_concurrency());
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(jobs, steps.count));
  const std::shared_ptr<Counter> counters = batch::Share<Counter>(1 + count);
  const std::array<int, 2> ends = batch::MakeSockets(SOCK_SEQPACKET);
  std::vector<::pid_t> children;
  for (std::size_t i = 0; i < count; ++i) {
    const ::pid_t child = batch::Fork("cannot fork");
    if (child == 0) {
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
  for (const ::pid_t child : children) status = Worse(status, StatusOfChild(child));
  return status;
}

}  // namespace mjforge::app
