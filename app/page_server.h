// The HTTP server of `mjforge customize`, for browsers on this machine.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page_connection.h"
#include "request_queue.h"
#include "watched_files.h"

namespace mjforge::app {

/// Serves the page of a spec at 127.0.0.1. A single thread serves all connections. A worker process
/// answers short requests, and a second worker process answers requests that take long.
class PageServer {
 public:
  using Request = boost::beast::http::request<boost::beast::http::string_body>;
  using Response = boost::beast::http::response<boost::beast::http::string_body>;
  using Respond = std::function<void(Response)>;

  PageServer(boost::asio::io_context& io, const WorkerMaker& make, Seconds time_limit);

  /// Listens at a port, or at any free port if `port` is 0. Returns the reason of a failure, or an
  /// empty text.
  std::string Listen(std::uint16_t port);
  /// Returns the page's address, which contains the token.
  std::string Address() const;

  /// Returns the response to a request that is too long to be read.
  static Response TooLong();
  /// Returns the response that rejects a request; nullopt if the request is allowed.
  std::optional<Response> Refusal(const Request& request) const;
  /// Answers a request that was not rejected, at once or later.
  void Answer(const Request& request, const Respond& respond);
  /// Exempts a connection from the limit of connections without token: its request had the token.
  void Trust(std::uint64_t number) { strangers_.erase(number); }

 private:
  // Request of a page that waits for a change of the spec's files.
  struct Waiting {
    std::uint64_t revision = 0;
    std::chrono::steady_clock::time_point end;
    Respond respond;
  };

  void Accept();
  void AnswerGet(std::string_view name, std::string_view query, const Respond& respond);
  void AnswerPost(std::string_view name, std::string_view query, const std::string& body,
                  const Respond& respond);
  Response AnswerOf(const RequestQueue::Outcome& outcome);
  void Tick();

  boost::asio::io_context& io_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer timer_;
  RequestQueue queue_;
  RequestQueue slow_queue_;  // films and physical checks, for which pictures need not wait
  std::string token_;
  std::uint64_t revision_ = 0;
  WatchedFiles watched_;
  std::vector<Waiting> waiting_;
  // Connections that have not yet sent a request with the token, by number.
  std::map<std::uint64_t, CloseConnection> strangers_;
  std::uint64_t accepted_ = 0;  // number of the last accepted connection
};

/// Encodes an answer of the worker for AnswerOf(): the names of the files to watch, and the body of
/// the HTTP response.
std::string EncodeAnswer(const std::vector<std::filesystem::path>& files, std::string_view json,
                         std::string_view picture);

}  // namespace mjforge::app
