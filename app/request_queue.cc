// Passing of requests to a worker process by asynchronous input and output, with a time limit.
#include "request_queue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

namespace mjforge::app {

namespace asio = boost::asio;
using boost::system::error_code;

void RequestQueue::Add(const std::string& client, std::string request, Done done) {
  const auto older = std::ranges::find_if(
      waiting_, [&](const Job& job) { return !client.empty() && job.client == client; });
  if (older != waiting_.end()) {
    const Done replaced = std::move(older->done);
    waiting_.erase(older);
    replaced({Outcome::Kind::kReplaced, {}});
  }
  if (replace_ == Replace::kRunning && current_ && !client.empty() && current_->client == client) {
    is_replaced_ = true;
    process_.Kill();
  }
  waiting_.push_back({client, std::move(request), std::move(done)});
  Next();
}

void RequestQueue::Next() {
  if (current_ || waiting_.empty()) return;
  current_ = std::move(waiting_.front());
  waiting_.pop_front();
  is_late_ = is_replaced_ = false;
  if (!socket_.is_open()) socket_.assign({}, process_.Start());
  timer_.expires_after(std::chrono::duration_cast<std::chrono::milliseconds>(time_limit_));
  timer_.async_wait([this](error_code error) {
    // Ignores the timer of an earlier request, which may have expired just before that request was
    // answered.
    if (error || !current_ || timer_.expiry() > std::chrono::steady_clock::now()) return;
    is_late_ = true;
    process_.Kill();
  });
  Send();
}

// Returns a handler that continues with `next`, or with Fail after an error.
auto RequestQueue::Then(void (RequestQueue::*next)()) {
  return [this, next](error_code error, std::size_t) {
    (this->*(error ? &RequestQueue::Fail : next))();
  };
}

void RequestQueue::Send() {
  head_ = WorkerProcess::Head(current_->request.size());
  const std::array<asio::const_buffer, 2> buffers = {asio::buffer(head_),
                                                     asio::buffer(current_->request)};
  asio::async_write(socket_, buffers, Then(&RequestQueue::Receive));
}

void RequestQueue::Receive() {
  head_.assign(WorkerProcess::kHeadBytes, '\0');
  asio::async_read(socket_, asio::buffer(head_), Then(&RequestQueue::ReceiveBody));
}

void RequestQueue::ReceiveBody() {
  body_.assign(WorkerProcess::LengthOf(head_), '\0');
  asio::async_read(socket_, asio::buffer(body_), Then(&RequestQueue::Succeed));
}

void RequestQueue::Succeed() { Finish({Outcome::Kind::kAnswered, std::move(body_)}); }

// Ends the worker process and returns the reason of its end.
std::string RequestQueue::StopWorker() {
  error_code ignored;
  socket_.close(ignored);
  return process_.Stop();
}

void RequestQueue::Fail() {
  std::string reason = StopWorker();
  if (is_replaced_) return Finish({Outcome::Kind::kReplaced, {}});
  if (is_late_) reason = fmt::format("took more than {:g} s", time_limit_.count());
  Finish({Outcome::Kind::kFailed, std::move(reason)});
}

void RequestQueue::Finish(Outcome outcome) {
  timer_.cancel();
  // Ends a worker that was killed just after it sent the answer.
  if ((is_late_ || is_replaced_) && socket_.is_open()) StopWorker();
  const Done done = std::move(current_->done);
  current_.reset();
  done(std::move(outcome));
  Next();
}

}  // namespace mjforge::app
