// Queue of requests to a worker process, in which newer requests replace older ones.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "console.h"
#include "worker_process.h"

namespace mjforge::app {

/// Passes requests to a worker process, one at a time and in order. The worker is started with the
/// first request, and again after a request that made it crash or took too long.
class RequestQueue {
 public:
  struct Outcome {
    enum class Kind { kAnswered, kReplaced, kFailed };
    Kind kind = Kind::kAnswered;
    std::string text;  // the answer, or the reason of the failure
  };
  using Done = std::function<void(Outcome)>;

  /// Requests that a newer request of the same client replaces. kWaiting: only requests that wait.
  /// kRunning: also the request that the worker is answering; the worker is killed, which is useful
  /// if answers take longer than the start of a worker.
  enum class Replace { kWaiting, kRunning };

  RequestQueue(boost::asio::io_context& io, WorkerMaker make, Seconds time_limit, Replace replace)
      : process_(std::move(make)),
        socket_(io),
        timer_(io),
        time_limit_(time_limit),
        replace_(replace) {}

  /// Adds a request, which replaces an earlier request of the same client, unless `client` is
  /// empty.
  void Add(const std::string& client, std::string request, Done done);

 private:
  struct Job {
    std::string client;
    std::string request;
    Done done;
  };

  void Next();
  void Send();
  void Receive();
  void ReceiveBody();
  void Succeed();
  auto Then(void (RequestQueue::*next)());
  /// Ends the current job after an error of the socket, which means that the worker has ended.
  void Fail();
  void Finish(Outcome outcome);
  std::string StopWorker();

  WorkerProcess process_;
  boost::asio::local::stream_protocol::socket socket_;
  boost::asio::steady_timer timer_;
  Seconds time_limit_;
  std::deque<Job> waiting_;
  std::optional<Job> current_;
  Replace replace_;
  // True if the worker was killed because the current job exceeded the time limit, or was replaced.
  bool is_late_ = false;
  bool is_replaced_ = false;
  std::string head_;
  std::string body_;
};

}  // namespace mjforge::app
