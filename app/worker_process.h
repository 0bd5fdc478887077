// Child process that answers requests; can be started again after a crash or after a kill.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <string_view>

namespace mjforge::app {

/// Answers one request. Runs in the child process.
using Worker = std::function<std::string(std::string_view request)>;
/// Makes the worker, in the child process.
using WorkerMaker = std::function<Worker()>;

/// The child process and a socket to it. Requests and answers are preceded by their length, 8 bytes
/// in the machine's byte order. The process has at most 8 GiB of memory, ignores Ctrl-C, and ends
/// with this process or when the socket is closed.
class WorkerProcess {
 public:
  static constexpr std::size_t kHeadBytes = 8;

  explicit WorkerProcess(WorkerMaker make) : make_(std::move(make)) {}
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;
  ~WorkerProcess() { Stop(); }

  /// Starts the process and returns this end of the socket, which the caller closes. The calling
  /// process must have a single thread.
  int Start();
  /// Kills the process; Stop must follow.
  void Kill() const;
  /// Kills the process, if it still runs, and returns the reason of its end: "made MuJoCo crash
  /// (SIGSEGV)".
  std::string Stop();

  static std::string Head(std::size_t bytes);
  static std::size_t LengthOf(std::string_view head);

 private:
  [[noreturn]] void Serve(int socket) const;

  WorkerMaker make_;
  ::pid_t process_ = 0;
};

}  // namespace mjforge::app
