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

// Returns false, without a signal, if the other end is closed.
bool SendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

// Receives exactly `size` bytes; returns false at the end of the stream.
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

}  // namespace

::pid_t Fork(const char* failure) {
  std::fflush(nullptr);  // otherwise both processes write the buffered output
  const ::pid_t parent = ::getpid();
  const ::pid_t child = ::fork();
  if (child < 0) ThrowError(failure);
  if (child > 0) return child;
  EndWith(parent, SIGKILL);
  return 0;
}

void EndWith(::pid_t parent, int signal) {
  ::prctl(PR_SET_PDEATHSIG, signal);
  if (::getppid() != parent) std::raise(signal);  // the parent ended before prctl
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

bool WriteLength(int socket, std::uint64_t size) {
  return SendAll(socket, {reinterpret_cast<const char*>(&size), sizeof(size)});
}

bool WriteMessage(int socket, std::string_view message) {
  return WriteLength(socket, message.size()) && SendAll(socket, message);
}

std::optional<std::string> ReadMessage(int socket) {
  std::uint64_t size = 0;
  if (!ReceiveAll(socket, reinterpret_cast<char*>(&size), sizeof(size))) return std::nullopt;
  std::string message(size, '\0');
  if (!ReceiveAll(socket, message.data(), size)) return std::nullopt;
  return message;
}

std::shared_ptr<void> ShareBytes(std::size_t size) {
  void* const memory =
      ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) ThrowError("cannot share memory");
  return {memory, [size](void* shared) { ::munmap(shared, size); }};
}

}  // namespace mjforge::batch
