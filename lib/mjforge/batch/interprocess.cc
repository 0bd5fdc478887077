// Child processes with fork(2), Unix sockets, and anonymous shared memory.

#include "mjforge/batch/interprocess.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace mjforge::batch {
namespace {

[[noreturn]] void ThrowError(const char* failure) {
  throw std::system_error(errno, std::generic_category(), failure);
}

}  // namespace

::pid_t Fork(const char* failure) {
  std::fflush(nullptr);  // otherwise both processes write the buffered output
  const ::pid_t parent = ::getpid();
  const ::pid_t child = ::fork();
  if (child < 0) ThrowError(failure);
  if (child > 0) return child;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) std::_Exit(0);  // the parent ended before prctl
  return 0;
}

int WaitForEnd(::pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

void EndBySignalOf(int wait_status) {
  const int signal = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
  if (signal != SIGINT && signal != SIGTERM && signal != SIGHUP) return;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::array<int, 2> MakeSockets(int type) {
  std::array<int, 2> ends = {};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0)
    ThrowError("cannot make a socket");
  return ends;
}

bool SendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

bool ReceiveAll(int socket, char* out, std::size_t size) {
  while (size > 0) {
    const ::ssize_t received = ::read(socket, out, size);
    if (received < 0 && errno == EINTR) continue;
    if (received <= 0) return false;
    out += received;
    size -= static_cast<std::size_t>(received);
  }
  return true;
}

std::shared_ptr<void> ShareBytes(std::size_t size) {
  void* const memory =
      ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) ThrowError("cannot share memory");
  return {memory, [size](void* shared) { ::munmap(shared, size); }};
}

}  // namespace mjforge::batch
