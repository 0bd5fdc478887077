#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "mjforge/batch/message.h"

namespace mjforge::batch {

/// What a worker shows of itself while it works, and its results, in memory that both processes
/// see.
class Slot {
 public:
  void Begin(std::uint64_t index) {
    index_.store(index, std::memory_order_relaxed);
    turn_.fetch_add(1, std::memory_order_release);  // odd: at work
  }
  void End() { turn_.fetch_add(1, std::memory_order_release); }
  /// Even: not at work on a variant.
  std::uint64_t turn() const { return turn_.load(std::memory_order_acquire); }
  std::uint64_t index() const { return index_.load(std::memory_order_relaxed); }

  void AskToStop() { stop_.store(true, std::memory_order_relaxed); }
  bool IsAskedToStop() const { return stop_.load(std::memory_order_relaxed); }

  /// Leaves a message, which saves two copies through a channel; false if it is too long, or the
  /// last one was not taken yet.
  bool Leave(std::string_view message) {
    if (message.size() > mail_.size() || mail_size_.load(std::memory_order_acquire) != 0)
      return false;
    message.copy(mail_.data(), message.size());
    mail_size_.store(message.size(), std::memory_order_release);
    return true;
  }
  /// The message that was left. It stays until it is removed.
  std::string_view mail() const {
    // A worker that crashes may have written anywhere.
    return {mail_.data(), std::min(mail_size_.load(std::memory_order_acquire), mail_.size())};
  }
  void RemoveMail() { mail_size_.store(0, std::memory_order_release); }

 private:
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  std::atomic<std::uint64_t> index_ = 0;
  std::atomic<std::uint64_t> turn_ = 0;
  std::atomic<bool> stop_ = false;
  std::atomic<std::uint64_t> mail_size_ = 0;
  std::array<char, std::size_t{2} << 20> mail_;  // most results of a chunk fit
};

/// Does tasks, in the worker.
using Work = std::function<Result(const Task&, Slot&)>;

/// Worker processes. One that a signal ends, or that takes more than the limit for one variant (CPU
/// time; WallLimit of wall time), is replaced; its tasks go to others, with the variant it worked
/// on condemned. One that does nothing for WallLimit between two variants is replaced, too. Workers
/// end with this process, however it ends.
class Pool {
 public:
  /// `make_work` is called in each worker when it starts.
  Pool(std::uint64_t jobs, std::chrono::duration<double> time_limit,
       std::function<Work()> make_work);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Whether a submitted task would start soon.
  bool HasRoom() const;
  void Submit(Task task);
  /// The next available result, in any order; nothing if none comes within a tenth of a second.
  /// Throws std::runtime_error if workers cannot be started, or end again and again before they
  /// begin a variant.
  std::optional<Result> Wait();
  /// Workers end after their current variant; tasks that have not begun are dropped.
  void AskToStop();
  /// Whether results are still to come.
  bool IsBusy() const;

 private:
  struct Worker;
  void Start(Worker& worker);
  void Feed();
  void Send(Worker& worker, Task task);
  void Receive(Worker& worker);
  void Replace(Worker& worker);
  void KillSlowWorkers();
  void NoteProgress(Worker& worker) const;

  std::chrono::duration<double> time_limit_;
  std::function<Work()> make_work_;
  std::vector<char> received_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::deque<Task> waiting_;
  std::deque<Result> results_;
  int fruitless_deaths_ = 0;  // in a row
  std::chrono::steady_clock::time_point looked_at_;
  std::chrono::duration<double> watched_{};  // wall time, without what this process was stopped
  bool stopped_ = false;
};

}  // namespace mjforge::batch
