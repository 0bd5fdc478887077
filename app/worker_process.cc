// A child process that answers requests, and is replaced when one of them makes it crash or hang.
#include "worker_process.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <system_error>

#include "child_process.h"
#include "mjforge/batch/batch.h"

namespace mjforge::app {
namespace {

// Reads exactly `size` bytes; returns false at the end of the stream.
bool ReceiveAll(int socket, char* out, std::size_t size) {
  while (size > 0) {
    const ::ssize_t read = ::read(socket, out, size);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    out += read;
    size -= static_cast<std::size_t>(read);
  }
  return true;
}

bool SendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(socket, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// Closes all files but standard input, output and error, and `kept`, so that the process does not
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
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot make a socket");
  std::fflush(nullptr);  // otherwise both processes write the buffered output
  const ::pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "cannot fork");
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) std::_Exit(0);  // the parent ended before prctl
    Serve(ends[1]);
  }
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
    std::string head(kHeadBytes, '\0');
    while (ReceiveAll(socket, head.data(), head.size())) {
      std::string request(LengthOf(head), '\0');
      if (!ReceiveAll(socket, request.data(), request.size())) break;
      const std::string reply = answer(request);
      if (!SendAll(socket, Head(reply.size())) || !SendAll(socket, reply)) break;
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
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  }
  process_ = 0;
  return DescribeEnd(status);
}

}  // namespace mjforge::app
