// The pool of worker processes: their shared memory, tasks and results, time limits, replacement.

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

/// Limit of tasks that are assigned to a worker in advance.
inline constexpr std::size_t kMaxTasksPerWorker = 4;

/// Memory shared by the leader (the process that runs the batch) and one worker: the worker's
/// progress, and results on their way to the leader.
class WorkerMailbox {
 public:
  /// Called by the worker before it makes a variant.
  void Begin(std::uint64_t index) {
    index_.store(index, std::memory_order_relaxed);
    turn_.fetch_add(1, std::memory_order_release);  // odd: working
  }
  /// Called by the worker after it made a variant.
  void End() { turn_.fetch_add(1, std::memory_order_release); }
  /// Number of calls of Begin and End; odd while the worker makes a variant.
  std::uint64_t turn() const { return turn_.load(std::memory_order_acquire); }
  /// Index of the variant that was begun last.
  std::uint64_t index() const { return index_.load(std::memory_order_relaxed); }

  /// Asks the worker to stop after its current variant.
  void AskToStop() { stop_.store(true, std::memory_order_relaxed); }
  bool IsAskedToStop() const { return stop_.load(std::memory_order_relaxed); }

  /// Returns shared memory for a message, which saves copying it through the channel; null if the
  /// message is too long or no buffer is free. The memory is always the first free buffer, which is
  /// probably still in the processor's cache.
  char* BufferFor(std::size_t size) {
    if (size > kBufferBytes) return nullptr;
    const auto is_free = [](const SharedMessage& message) {
      return message.size.load(std::memory_order_acquire) == 0;
    };
    const auto found = std::ranges::find_if(messages_, is_free);
    return found == messages_.end() ? nullptr : found->bytes.data();
  }
  /// Publishes the message of `size` bytes in the memory `room` that BufferFor returned. Returns
  /// the message's number, less than kMaxTasksPerWorker.
  std::uint64_t Publish(const char* room, std::size_t size) {
    SharedMessage& message = MessageAt(room);
    message.size.store(size, std::memory_order_release);
    return static_cast<std::uint64_t>(&message - messages_.data());
  }
  /// Returns the published message with this number, which remains until it is released.
  std::string_view Take(std::uint64_t number) const {
    const SharedMessage& message = messages_.at(number);
    // Limits the size, because a crashing worker may have overwritten it.
    return {message.bytes.data(),
            std::min(message.size.load(std::memory_order_acquire), message.bytes.size())};
  }
  /// Frees the buffer of a message that Take returned.
  void Release(std::string_view message) {
    MessageAt(message.data()).size.store(0, std::memory_order_release);
  }

 private:
  static constexpr std::size_t kBufferBytes = std::size_t{2} << 20;  // enough for most results
  struct SharedMessage {
    std::atomic<std::uint64_t> size = 0;
    std::array<char, kBufferBytes> bytes;
  };

  SharedMessage& MessageAt(const char* room) {
    return *std::ranges::find_if(messages_,
                                 [&](const SharedMessage& m) { return m.bytes.data() == room; });
  }

  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  std::atomic<std::uint64_t> index_ = 0;
  std::atomic<std::uint64_t> turn_ = 0;
  std::atomic<bool> stop_ = false;
  std::array<SharedMessage, kMaxTasksPerWorker> messages_;
};

/// A function that performs a task in a worker.
using TaskHandler = std::function<ChunkResult(const Task&, WorkerMailbox&)>;

/// Runs tasks in worker processes. A worker is replaced if a signal ends it, if one variant takes
/// more CPU time than the time limit or more wall time than WallLimit(), or if the worker reports
/// nothing for WallLimit() between two variants. The variant that the worker was making is
/// quarantined: recorded as failed in this run. Other workers take over the rest of the worker's
/// tasks. All workers end when this process ends, for whatever reason.
class Pool {
 public:
  /// Each worker calls `make_handler` when it starts. A worker has up to `tasks_per_worker` tasks
  /// assigned, so that it does not wait for its next task.
  Pool(std::uint64_t jobs, std::size_t tasks_per_worker, std::chrono::duration<double> time_limit,
       std::function<TaskHandler()> make_handler);
  ~Pool();

  /// Returns true if a worker has room for a task, no task waits for a worker, and results do not
  /// pile up.
  bool HasRoom() const;
  void Submit(Task task);
  /// Returns a result, in any order, or nullopt if none is available. With `may_wait`, waits for a
  /// result for up to a tenth of a second. Throws std::runtime_error if workers cannot be started
  /// or repeatedly end before they begin a variant.
  std::optional<ChunkResult> Wait(bool may_wait = true);
  /// Asks all workers to stop after their current variants, and drops tasks that no worker has.
  void AskToStop();
  /// Returns true if results are available or tasks are assigned.
  bool IsBusy() const;
  /// Returns true if a worker that had a task died, because such a worker may have left an
  /// incomplete file.
  bool has_lost_worker() const { return has_lost_worker_; }

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
  std::unique_ptr<char[]> received_;  // buffer for reading from channels
  std::vector<std::unique_ptr<WorkerProcess>> workers_;
  std::deque<Task> waiting_;  // tasks that no worker has
  std::deque<ChunkResult> results_;
  int idle_deaths_ = 0;  // consecutive deaths of workers that were not making a variant
  std::chrono::steady_clock::time_point last_look_;  // last check for slow workers
  std::chrono::duration<double> watch_time_{};  // wall time, except while this process was stopped
  bool stopped_ = false;
  bool has_lost_worker_ = false;
};

}  // namespace mjforge::batch
