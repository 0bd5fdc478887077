// Worker processes: forking, channels, shared memory, time limits, and replacement of dead workers.

#include "mjforge/batch/pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <stdexcept>

namespace mjforge::batch {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr int kPollMilliseconds = 100;
// Size of the buffers of a channel, the pair of sockets between the leading process and a worker,
// in bytes. Most results fit into such a buffer, which saves context switches.
constexpr int kBufferBytes = 1 << 20;
constexpr int kBugStatus = 70;  // EX_SOFTWARE of sysexits.h
// Limit of consecutive deaths of workers that were not making a variant. After more, the batch
// fails.
constexpr int kMaxIdleDeaths = 10;
// Largest part of the time between two checks of the workers that counts as wall time. A longer
// time means that the leading process and the workers were stopped (Ctrl-Z).
constexpr Seconds kMaxLookInterval{1};

// Value that is sent in place of a length, plus the number of the message, if the message is in the
// worker's mailbox.
constexpr std::uint64_t kInSharedMemory = ~std::uint64_t{0} - kMaxTasksPerWorker;

bool WriteResult(int channel, WorkerMailbox& mailbox, const ChunkResult& result) {
  const std::size_t size = EncodedSize(result);
  char* const room = mailbox.BufferFor(size);
  if (room == nullptr) return WriteMessage(channel, Encode(result));
  EncodeTo(room, result);
  return WriteLength(channel, kInSharedMemory + mailbox.Publish(room, size));
}

// Performs tasks until the channel closes. Ignores SIGINT and SIGTERM, which the leading process
// handles.
[[noreturn]] void RunWorker(const std::function<TaskHandler()>& make_handler, int channel,
                            WorkerMailbox& mailbox) {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  int status = 0;
  try {
    const TaskHandler work = make_handler();
    while (const std::optional<std::string> message = ReadMessage(channel)) {
      if (!WriteResult(channel, mailbox, work(DecodeTask(*message), mailbox))) break;
    }
  } catch (const std::bad_alloc&) {
    status = kNoMemoryStatus;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mjforge: internal error in a worker: {}\n", diag::SafeText(error.what()));
    status = kBugStatus;
  }
  std::exit(status);
}

// Decodes a message in the mailbox. The message's buffer is free again when the result is
// destroyed.
ChunkResult ReadSharedResult(const std::shared_ptr<WorkerMailbox>& mailbox, std::uint64_t number) {
  const std::string_view message = mailbox->Take(number);
  return DecodeResult(
      message, {message.data(), [mailbox, message](const char*) { mailbox->Release(message); }});
}

ChunkResult ReadResult(std::string_view message) {
  auto memory = std::make_shared<const std::string>(message);
  return DecodeResult(*memory, memory);
}

// Returns the CPU time of all threads of a process; 0 if the time cannot be read, for example after
// the end of the process.
Seconds CpuTime(::pid_t process) {
  ::clockid_t clock = {};
  std::timespec time = {};
  if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return {};
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

std::string DescribeExit(int status) {
  if (WIFSIGNALED(status)) {
    const char* name = ::sigabbrev_np(WTERMSIG(status));
    return fmt::format("was killed by SIG{}", name == nullptr ? "?" : name);
  }
  if (WEXITSTATUS(status) == kNoMemoryStatus) return "needs more memory than there is";
  return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace

struct Pool::WorkerProcess {
  ::pid_t process = -1;
  int channel = -1;
  std::deque<Task> assigned;
  std::string buffer;                      // encoded results; the last one may be incomplete
  std::shared_ptr<WorkerMailbox> mailbox;  // null until the first start
  // State of the worker when it last made progress.
  std::uint64_t last_turn = 0;
  Seconds last_change{};  // value of Pool::watch_time_
  Seconds last_cpu_time{};
  std::string too_slow;  // reason for killing a slow worker; empty: not killed

  void Close() {
    if (channel >= 0) ::close(std::exchange(channel, -1));
  }
};

Pool::Pool(std::uint64_t jobs, std::size_t tasks_per_worker,
           std::chrono::duration<double> time_limit, std::function<TaskHandler()> make_handler)
    : tasks_per_worker_(tasks_per_worker),
      time_limit_(time_limit),
      make_handler_(std::move(make_handler)),
      received_(std::make_unique_for_overwrite<char[]>(kBufferBytes)) {
  for (std::uint64_t i = 0; i < jobs; ++i) workers_.push_back(std::make_unique<WorkerProcess>());
}

// Ends idle workers by closing their channels. Kills workers with tasks, because such a worker may
// hang.
Pool::~Pool() {
  for (const auto& worker : workers_) {
    const bool runs = worker->process > 0;
    // SIGCONT wakes an idle worker that was stopped (Ctrl-Z). The signal is sent before Close(),
    // which makes the worker exit: during the exit, SIGCONT would revoke the SIGSTOP with which the
    // leak check of AddressSanitizer attaches to the process, and the check would wait forever.
    if (runs) ::kill(worker->process, worker->assigned.empty() ? SIGCONT : SIGKILL);
    worker->Close();
    if (runs) ::waitpid(worker->process, nullptr, 0);
  }
}

void Pool::Start(WorkerProcess& worker) {
  const auto [leader_end, worker_end] = MakeSockets(SOCK_STREAM);
  // Ignores failures: smaller buffers only cost more context switches.
  for (const int end : {leader_end, worker_end})
    ::setsockopt(end, SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof(int));
  worker.mailbox = Share<WorkerMailbox>();  // results may still refer to the previous mailbox
  const ::pid_t process = Fork("cannot start a worker");
  if (process == 0) {
    // Open copies of other workers' channels would keep these workers alive.
    for (const auto& other : workers_) other->Close();
    ::close(leader_end);
    RunWorker(make_handler_, worker_end, *worker.mailbox);
  }
  ::close(worker_end);
  worker.process = process;
  worker.channel = leader_end;
  worker.too_slow.clear();
}

bool Pool::HasRoom() const {
  const auto has_room = [this](const auto& worker) {
    return worker->assigned.size() < tasks_per_worker_;
  };
  // Accepts no more tasks if results are taken more slowly than they arrive.
  const bool keeps_up = results_.size() <= workers_.size();
  return !stopped_ && keeps_up && waiting_.empty() && std::ranges::any_of(workers_, has_room);
}

void Pool::Submit(Task task) {
  waiting_.push_back(std::move(task));
  Feed();
}

// Gives waiting tasks to the workers with the fewest tasks.
void Pool::Feed() {
  while (!waiting_.empty() && !stopped_) {
    const auto least = std::ranges::min_element(
        workers_, {}, [](const auto& worker) { return worker->assigned.size(); });
    if ((*least)->assigned.size() == tasks_per_worker_) return;
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    Send(**least, std::move(task));
  }
}

void Pool::Send(WorkerProcess& worker, Task task) {
  if (worker.process < 0) Start(worker);
  if (worker.assigned.empty()) RecordProgress(worker);
  const std::string message = Encode(task);
  worker.assigned.push_back(std::move(task));
  // A failure means that the worker is dead; Receive() replaces the worker.
  WriteMessage(worker.channel, message);
}

bool Pool::IsBusy() const {
  const auto has_task = [](const auto& worker) { return !worker->assigned.empty(); };
  return !results_.empty() || std::ranges::any_of(workers_, has_task);
}

std::optional<ChunkResult> Pool::Wait(bool may_wait) {
  std::vector<::pollfd> polled;
  // poll ignores workers that are not started, because their channel is -1.
  for (const auto& worker : workers_) polled.push_back({worker->channel, POLLIN, 0});
  ::poll(polled.data(), polled.size(), may_wait && results_.empty() ? kPollMilliseconds : 0);
  for (std::size_t i = 0; i < polled.size(); ++i) {
    if (polled[i].revents != 0) Receive(*workers_[i]);
  }
  KillSlowWorkers();
  Feed();
  if (results_.empty()) return std::nullopt;
  ChunkResult result = std::move(results_.front());
  results_.pop_front();
  return result;
}

void Pool::Receive(WorkerProcess& worker) {
  bool ended = false;
  while (true) {
    const ssize_t got = ::recv(worker.channel, received_.get(), kBufferBytes, MSG_DONTWAIT);
    if (got > 0) {
      worker.buffer.append(received_.get(), static_cast<std::size_t>(got));
      continue;
    }
    if (got < 0 && errno == EINTR) continue;
    ended = got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK);
    break;
  }
  std::size_t at = 0;
  std::uint64_t size = 0;
  while (worker.buffer.size() - at >= sizeof(size)) {
    std::memcpy(&size, worker.buffer.data() + at, sizeof(size));
    const bool is_shared = size >= kInSharedMemory;
    const std::uint64_t number = size - kInSharedMemory;
    if (is_shared) size = 0;
    if (worker.buffer.size() - at - sizeof(size) < size) break;
    results_.push_back(
        is_shared ? ReadSharedResult(worker.mailbox, number)
                  : ReadResult(std::string_view(worker.buffer).substr(at + sizeof(size), size)));
    worker.assigned.pop_front();
    RecordProgress(worker);
    idle_deaths_ = 0;
    at += sizeof(size) + size;
  }
  worker.buffer.erase(0, at);
  if (ended) Replace(worker);
}

void Pool::Replace(WorkerProcess& worker) {
  const int status = WaitForEnd(worker.process);
  worker.process = -1;
  worker.Close();
  worker.buffer.clear();
  std::deque<Task> tasks = std::exchange(worker.assigned, {});
  if (tasks.empty()) return;
  has_lost_worker_ = true;
  Task& first = tasks.front();
  const std::string how = worker.too_slow.empty() ? DescribeExit(status) : worker.too_slow;
  const bool at_work = worker.mailbox->turn() % 2 == 1;
  if (at_work) {
    first.quarantined.push_back({worker.mailbox->index(), !worker.too_slow.empty(), how});
  } else if (++idle_deaths_ > kMaxIdleDeaths) {
    throw std::runtime_error(fmt::format("workers cannot run: the last one {}", how));
  }
  // Retried tasks go to the front of the queue, because results are needed in index order.
  waiting_.insert(waiting_.begin(), std::make_move_iterator(tasks.begin()),
                  std::make_move_iterator(tasks.end()));
}

void Pool::RecordProgress(WorkerProcess& worker) const {
  worker.last_turn = worker.mailbox->turn();
  worker.last_change = watch_time_;
  worker.last_cpu_time = CpuTime(worker.process);
}

void Pool::KillSlowWorkers() {
  const Clock::time_point now = Clock::now();
  watch_time_ += std::min<Seconds>(now - last_look_, kMaxLookInterval);
  last_look_ = now;
  const Seconds patience = WallLimit(time_limit_);
  for (const auto& worker : workers_) {
    if (worker->process < 0 || worker->assigned.empty() || !worker->too_slow.empty()) continue;
    const std::uint64_t turn = worker->mailbox->turn();
    const bool at_work = turn % 2 == 1;
    if (turn != worker->last_turn) {
      RecordProgress(*worker);
    } else if (at_work && CpuTime(worker->process) - worker->last_cpu_time > time_limit_) {
      worker->too_slow = fmt::format("took more than {:g} s of CPU time", time_limit_.count());
    } else if (watch_time_ - worker->last_change > patience) {
      worker->too_slow = fmt::format("took more than {:g} s of wall time", patience.count());
    }
    if (!worker->too_slow.empty()) ::kill(worker->process, SIGKILL);
  }
}

// Asks the workers to stop. The results of unfinished tasks contain the variants made so far.
void Pool::AskToStop() {
  stopped_ = true;
  waiting_.clear();
  for (const auto& worker : workers_) {
    if (worker->mailbox) worker->mailbox->AskToStop();
  }
}

}  // namespace mjforge::batch
