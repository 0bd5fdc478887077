// Child process that answers requests over a socket: start, loop of requests, end.
#include "worker_process.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <new>

#include "child_process.h"
#include "mjforge/batch/batch.h"

namespace mjforge::app {
namespace {

// Closes all files except standard input, output, error, and `kept`, so that the process does not
// hold the connections of browsers open.
void CloseOtherFiles(int kept) {
  const auto file = static_cast<unsigned>(kept);
  constexpr unsigned kFirst = STDERR_FILENO + 1;
  if (file > kFirst) ::close_range(kFirst, file - 1, 0);
  ::close_range(file + 1, std::numeric_limits<int>::max(), 0);
}

}  // namespace

std::string WorkerProcess::Head(std::size_t bytes) {
  std::string head(kHeadBytes, '\0');
  const std::uint64_t length = bytes;
  std::memcpy(head.data(), &length, kHeadBytes);
  return head;
}

std::size_t WorkerProcess::LengthOf(std::string_view head) {
  std::uint64_t length = 0;
  std::memcpy(&length, head.data(), kHeadBytes);
  return length;
}

int WorkerProcess::Start() {
  const std::array<int, 2> ends = batch::MakeSockets(SOCK_STREAM);
  process_ = batch::Fork("cannot fork");
  if (process_ == 0) Serve(ends[1]);
  ::close(ends[1]);
  return ends[0];
}

void WorkerProcess::Serve(int socket) const {
  // Ignores these signals, because the parent ends on them and closes the socket.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  CloseOtherFiles(socket);
  LimitMemory();
  try {
    const Worker answer = make_();
    while (const std::optional<std::string> request = batch::ReadMessage(socket)) {
      if (!batch::WriteMessage(socket, answer(*request))) break;
    }
  } catch (const std::bad_alloc&) {
    std::_Exit(batch::kNoMemoryStatus);
  } catch (const std::exception&) {
    std::_Exit(static_cast<int>(ExitStatus::kBug));
  }
  std::_Exit(0);
}

void WorkerProcess::Kill() const {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

std::string WorkerProcess::Stop() {
  if (process_ == 0) return {};
  int status = 0;
  // Waits a moment, because a process that ends by itself closes its socket shortly before its end.
  constexpr int kTries = 50;
  constexpr ::useconds_t kPause = 2000;  // microseconds
  ::pid_t ended = 0;
  for (int i = 0; i < kTries && ended == 0; ++i) {
    ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == 0) ::usleep(kPause);
  }
  if (ended == 0) {
    ::kill(process_, SIGKILL);
    status = batch::WaitForEnd(process_);
  }
  process_ = 0;
  return DescribeEnd(status);
}

}  // namespace mjforge::app
