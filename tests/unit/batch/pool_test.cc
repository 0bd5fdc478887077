// Tests of worker processes: deaths, time limits, interruption.

#include "mjforge/batch/pool.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <map>
#include <new>
#include <thread>

namespace mjforge::batch {
namespace {

// Returns a pool whose results list the indices made; `fate` may end the process of a worker.
Pool MakePool(std::uint64_t jobs, std::chrono::duration<double> limit,
              std::function<void(std::uint64_t)> fate) {
  return Pool(jobs, 2, limit, [fate] {
    return [fate](const Task& task, WorkerMailbox& mailbox) {
      ChunkResult result;
      result.chunk = task.chunk;
      for (std::uint64_t i = task.chunk.first; i < task.chunk.end(); ++i) {
        const auto quarantined =
            std::find_if(task.quarantined.begin(), task.quarantined.end(),
                         [&](const QuarantinedVariant& c) { return c.index == i; });
        if (quarantined != task.quarantined.end()) {
          result.text += quarantined->how + ";";
          continue;
        }
        mailbox.Begin(i);
        fate(i);
        mailbox.End();
        result.text += std::to_string(i) + ";";
      }
      return result;
    };
  });
}

// Returns the text of each chunk of ten indices, by its first index.
std::map<std::uint64_t, std::string> Work100(Pool& pool) {
  std::map<std::uint64_t, std::string> texts;
  std::uint64_t next = 0;
  while (next < 100 || pool.IsBusy()) {
    while (next < 100 && pool.HasRoom()) {
      pool.Submit({{next, 10, 0}, {}});
      next += 10;
    }
    if (const auto result = pool.Wait()) texts[result->chunk.first] = result->text;
  }
  return texts;
}

TEST_CASE("every task is done once, by any number of workers") {
  for (const std::uint64_t jobs : {1, 3}) {
    Pool pool = MakePool(jobs, std::chrono::seconds(10), [](std::uint64_t) {});
    const auto texts = Work100(pool);
    REQUIRE(texts.size() == 10);
    CHECK(texts.at(30) == "30;31;32;33;34;35;36;37;38;39;");
  }
}

TEST_CASE("results that are taken slowly are not gathered without end") {
  using Count = std::atomic<std::uint64_t>;
  void* const memory =
      ::mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  REQUIRE(memory != MAP_FAILED);
  auto* const done = new (memory) Count(0);
  Pool pool = MakePool(2, std::chrono::seconds(10), [done](std::uint64_t) { ++*done; });
  std::uint64_t submitted = 0;
  std::uint64_t most = 0;  // largest number of tasks without a result
  for (std::uint64_t taken = 0; taken < 200;) {
    for (; submitted < 200 && pool.HasRoom(); ++submitted) pool.Submit({{submitted, 1, 0}, {}});
    most = std::max(most, submitted - taken);
    while (*done < submitted) std::this_thread::yield();
    if (pool.Wait()) ++taken;
  }
  CHECK(most <= 8);  // two tasks for each worker, and the results that may wait
  ::munmap(memory, sizeof(Count));
}

TEST_CASE("results of any length arrive whole and in order") {
  constexpr std::size_t kLong = std::size_t{5} << 20;
  Pool pool(1, kMaxTasksPerWorker, std::chrono::seconds(10), [] {
    return [](const Task& task, WorkerMailbox&) {
      ChunkResult result;
      result.chunk = task.chunk;
      const std::size_t length = task.chunk.first % 2 == 0 ? 10 : kLong;
      result.text = std::string(length, static_cast<char>('a' + task.chunk.first));
      return result;
    };
  });
  std::string order;
  for (std::uint64_t next = 0; next < 8 || pool.IsBusy();) {
    for (; next < 8 && pool.HasRoom(); ++next) pool.Submit({{next, 1, 0}, {}});
    const auto result = pool.Wait();
    if (!result) continue;
    order += result->text.front();
    CHECK(result->text.size() == (result->chunk.first % 2 == 0 ? 10 : kLong));
    CHECK(result->text.find_first_not_of(result->text.front()) == std::string::npos);
  }
  CHECK(order == "abcdefgh");
}

TEST_CASE("a mailbox holds a message for each task until they are removed") {
  const auto mailbox = std::make_unique<WorkerMailbox>();
  // Returns the number of the message; 99 if there is no room for it.
  const auto leave = [&mailbox](std::string_view message) -> std::uint64_t {
    char* const room = mailbox->BufferFor(message.size());
    if (room == nullptr) return 99;
    message.copy(room, message.size());
    return mailbox->Publish(room, message.size());
  };
  std::uint64_t number = 0;
  for (const std::string_view message : {"first", "second", "third", "fourth"})
    CHECK(leave(message) == number++);
  CHECK(leave("fifth") == 99);
  const std::string_view first = mailbox->Take(0);
  const std::string_view third = mailbox->Take(2);
  CHECK(first == "first");
  CHECK(third == "third");
  mailbox->Release(third);
  CHECK(leave(std::string(std::size_t{3} << 20, 'x')) == 99);
  CHECK(leave("fifth") == 2);
  CHECK(leave("sixth") == 99);
  mailbox->Release(first);
  CHECK(leave("sixth") == 0);
  for (const std::string_view message : {"sixth", "second", "fifth", "fourth"})
    CHECK(mailbox->Take(number++ % 4) == message);
}

TEST_CASE("results that are kept stay as they are, whatever becomes of their worker") {
  std::vector<ChunkResult> kept;
  {
    std::string lines;  // owned by the worker, overwritten for each result
    Pool pool(1, kMaxTasksPerWorker, std::chrono::seconds(10), [&lines] {
      return [&lines](const Task& task, WorkerMailbox& mailbox) {
        mailbox.Begin(task.chunk.first);
        if (task.chunk.first == 10 && task.quarantined.empty()) ::raise(SIGKILL);
        mailbox.End();
        lines.assign(1000, static_cast<char>('a' + task.chunk.first));
        ChunkResult result;
        result.chunk = task.chunk;
        result.lines = lines;
        return result;
      };
    });
    for (std::uint64_t next = 0; next < 20 || pool.IsBusy();) {
      for (; next < 20 && pool.HasRoom(); ++next) pool.Submit({{next, 1, 0}, {}});
      if (auto result = pool.Wait()) kept.push_back(*std::move(result));
    }
  }
  REQUIRE(kept.size() == 20);
  for (const ChunkResult& result : kept)
    CHECK(result.lines == std::string(1000, static_cast<char>('a' + result.chunk.first)));
}

TEST_CASE("a worker that a signal kills costs the variant it was at, and no other") {
  for (const int signal : {SIGSEGV, SIGKILL, SIGABRT}) {
    Pool pool = MakePool(2, std::chrono::seconds(10), [signal](std::uint64_t index) {
      if (index == 33 || index == 35 || index == 90) {
        std::signal(signal, SIG_DFL);  // remove the handlers of sanitizers and Catch
        ::kill(::getpid(), signal);
        std::this_thread::sleep_for(std::chrono::seconds(10));
      }
    });
    const auto texts = Work100(pool);
    const std::string died = std::string("was killed by SIG") + ::sigabbrev_np(signal) + ";";
    REQUIRE(texts.size() == 10);
    CHECK(texts.at(30) == "30;31;32;" + died + "34;" + died + "36;37;38;39;");
    CHECK(texts.at(90) == died + "91;92;93;94;95;96;97;98;99;");
    CHECK(texts.at(20) == "20;21;22;23;24;25;26;27;28;29;");
  }
}

TEST_CASE("a worker that ends by itself costs the variant it was at") {
  Pool pool = MakePool(2, std::chrono::seconds(10), [](std::uint64_t index) {
    if (index == 5) std::_Exit(7);
  });
  CHECK(Work100(pool).at(0) == "0;1;2;3;4;ended with status 7;6;7;8;9;");
}

TEST_CASE("a variant that takes too much CPU time is given up, and none that waits for a CPU") {
  Pool pool = MakePool(2, std::chrono::milliseconds(300), [](std::uint64_t index) {
    const auto start = std::chrono::steady_clock::now();
    while (index == 42 && std::chrono::steady_clock::now() - start < std::chrono::minutes(1)) {
    }
    if (index == 43) std::this_thread::sleep_for(std::chrono::seconds(1));
  });
  const auto texts = Work100(pool);
  CHECK(texts.at(40) == "40;41;took more than 0.3 s of CPU time;43;44;45;46;47;48;49;");
}

TEST_CASE("a variant that hangs is given up when ten times as much time and 5 s have passed") {
  Pool pool = MakePool(2, std::chrono::milliseconds(100), [](std::uint64_t index) {
    if (index == 42) std::this_thread::sleep_for(std::chrono::minutes(1));
  });
  const auto texts = Work100(pool);
  CHECK(texts.at(40) == "40;41;took more than 6 s of wall time;43;44;45;46;47;48;49;");
}

TEST_CASE("time in which the leading process is stopped is nobody's") {
  Pool pool = MakePool(1, std::chrono::milliseconds(100), [](std::uint64_t index) {
    if (index != 42) return;
    ::kill(::getppid(), SIGSTOP);
    std::this_thread::sleep_for(std::chrono::seconds(7));
    ::kill(::getppid(), SIGCONT);
    std::this_thread::sleep_for(std::chrono::seconds(1));
  });
  const auto texts = Work100(pool);
  CHECK(texts.at(40) == "40;41;42;43;44;45;46;47;48;49;");
}

TEST_CASE("a worker that is stopped while it has nothing to do ends with the others") {
  Pool pool = MakePool(1, std::chrono::seconds(10), [](std::uint64_t index) {
    if (index != 99) return;
    const ::pid_t worker = ::getpid();
    if (::fork() != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::kill(worker, SIGSTOP);
    std::_Exit(0);
  });
  CHECK(Work100(pool).size() == 10);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
}

TEST_CASE("workers that die before they begin anything do not go on for ever") {
  Pool pool(2, 2, std::chrono::seconds(10), []() -> TaskHandler { std::_Exit(9); });
  pool.Submit({{0, 2, 0}, {}});
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_WITH(
      [&] {
        while (std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) pool.Wait();
      }(),
      "workers cannot run: the last one ended with status 9");
}

TEST_CASE("asked to stop, workers leave what they have not begun") {
  Pool pool = MakePool(1, std::chrono::seconds(10), [](std::uint64_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  });
  pool.Submit({{0, 10, 0}, {}});
  pool.AskToStop();
  CHECK_FALSE(pool.HasRoom());
  while (pool.IsBusy()) pool.Wait();
}

}  // namespace
}  // namespace mjforge::batch
