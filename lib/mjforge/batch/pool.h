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

/// More tasks than this are not assigned to a worker in advance.
inline constexpr std::size_t kMaxTasksPerWorker = 4;

/// What a worker shows of itself while it works, and its results, in memory that both processes
/// see.
class WorkerMailbox {
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

  /// Memory for a result's message, which saves copies through a channel; null if it is too long,
  /// or as many are still there as fit.
  char* BufferFor(std::size_t size) {
    SharedMessage& message = messages_[published_ % messages_.size()];
    const bool is_free = message.size.load(std::memory_order_acquire) == 0;
    return is_free && size <= message.bytes.size() ? message.bytes.data() : nullptr;
  }
  /// The message that was written there.
  void Publish(std::size_t size) {
    messages_[published_++ % messages_.size()].size.store(size, std::memory_order_release);
  }
  /// The next message; one was left. It stays until it is removed.
  std::string_view Take() {
    const SharedMessage& message = messages_[taken_++ % messages_.size()];
    // A worker that crashes may have written anywhere.
    return {message.bytes.data(),
            std::min(message.size.load(std::memory_order_acquire), message.bytes.size())};
  }
  void Release(std::string_view message) {
    const auto is_it = [&](const SharedMessage& m) { return m.bytes.data() == message.data(); };
    std::ranges::find_if(messages_, is_it)->size.store(0, std::memory_order_release);
  }

 private:
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  std::atomic<std::uint64_t> index_ = 0;
  std::atomic<std::uint64_t> turn_ = 0;
  std::atomic<bool> stop_ = false;
  struct SharedMessage {
    std::atomic<std::uint64_t> size = 0;
    std::array<char, std::size_t{2} << 20> bytes;  // most results of a chunk fit
  };
  std::array<SharedMessage, kMaxTasksPerWorker> messages_;
  std::uint64_t published_ = 0;  // mails, by the worker
  std::uint64_t taken_ = 0;      // by the process that leads
};

/// Does tasks, in the worker.
using TaskHandler = std::function<ChunkResult(const Task&, WorkerMailbox&)>;

/// Worker processes. One that a signal ends, or that takes more than the limit for one variant (CPU
/// time; WallLimit of wall time), is replaced; its tasks go to others, with the variant it worked
/// on quarantined. One that does nothing for WallLimit between two variants is replaced, too.
/// Workers end with this process, however it ends.
class Pool {
 public:
  /// `make_handler` is called in each worker when it starts. A worker has up to `tasks_per_worker`
  /// tasks at hand, so that it need not wait when it is done with one.
  Pool(std::uint64_t jobs, std::size_t tasks_per_worker, std::chrono::duration<double> time_limit,
       std::function<TaskHandler()> make_handler);
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Whether a submitted task would start soon, and not too many results wait to be taken.
  bool HasRoom() const;
  void Submit(Task task);
  /// The next available result, in any order; nothing if none comes within a tenth of a second, or
  /// none is there and it may not wait. Throws std::runtime_error if workers cannot be started, or
  /// end again and again before they begin a variant.
  std::optional<ChunkResult> Wait(bool may_wait = true);
  /// Workers end after their current variant; tasks that have not begun are dropped.
  void AskToStop();
  /// Whether results are still to come.
  bool IsBusy() const;

 private:
  struct WorkerProcess;
  void Start(WorkerProcess& worker);
  void Feed();
  void Send(WorkerProcess& worker, Task task);
  void Receive(WorkerProcess& worker);
  void Replace(WorkerProcess& worker);
  void KillSlowWorkers();
  void RecordProgress(WorkerProcess& worker) const;

  std::size_t tasks_per_worker_;
  std::chrono::duration<double> time_limit_;
  std::function<TaskHandler()> make_handler_;
  std::unique_ptr<char[]> received_;
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::deque<Task> waiting_;
  std::deque<ChunkResult> results_;
  int idle_deaths_ = 0;  // in a row
  std::chrono::steady_clock::time_point last_look_;
  std::chrono::duration<double> watch_time_{};  // wall time, without what this process was stopped
  bool stopped_ = false;
};

}  // namespace mjforge::batch
