// Functions for child processes: fork, wait, exchange bytes, share memory.

#pragma once

#include <sys/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>

namespace mjforge::batch {

/// Forks this process. The child process is killed when this process ends. Returns the child's
/// process id, and 0 in the child process. Throws std::system_error with the message `failure` if
/// forking fails.
::pid_t Fork(const char* failure);

/// Sends `signal` to this process when its parent `parent` ends, at once if it has ended.
void EndWith(::pid_t parent, int signal);

/// Waits until a child process has ended; returns its wait status.
int WaitForEnd(::pid_t child);

/// Ends this process by the signal that ended its child, if the signal is SIGINT, SIGTERM or
/// SIGHUP, which a user or a batch system sends. Otherwise returns.
void EndBySignalOf(int wait_status);

/// Returns the two ends of a pair of connected sockets of this type (SOCK_STREAM).
std::array<int, 2> MakeSockets(int type);
// Functions that send to a stream return false, without a signal, if the other end is closed.
/// Sends a length of eight bytes, like that before a message.
bool WriteLength(int socket, std::uint64_t size);
/// Sends a message: its length, as eight bytes, and its bytes.
bool WriteMessage(int socket, std::string_view message);
/// Receives a message; returns nullopt at the end of the stream.
std::optional<std::string> ReadMessage(int socket);

/// Returns memory that child processes share with this process.
std::shared_ptr<void> ShareBytes(std::size_t size);
/// Returns `count` default-initialized objects in memory that child processes share.
template <typename T>
std::shared_ptr<T> Share(std::size_t count = 1) {
  const std::shared_ptr<void> memory = ShareBytes(count * sizeof(T));
  T* const first = static_cast<T*>(memory.get());
  for (std::size_t i = 0; i < count; ++i) new (first + i) T;
  return {memory, first};
}

}  // namespace mjforge::batch
