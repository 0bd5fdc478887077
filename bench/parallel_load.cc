// Benchmark of loading equal models in threads of one process and in processes: models per second
// of wall time, medians of runs in turn. MuJoCo loads one model at a time up to 3.1.1. For another
// release: `cmake build/mujoco-4.0.1 -D MJFORGE_BENCH=ON` after `./dev build --mujoco 4.0.1`.
//
//   mjforge_parallel_load [WORKERS [COUNT [RUNS]]]

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include <fmt/format.h>

#include "bare_load.h"

namespace {

using Texts = std::vector<std::string>;

void Load(const Texts& texts, int count) {
  mjforge::bench::BareLoader loader;
  for (int i = 0; i < count; ++i) loader.Load(texts[static_cast<std::size_t>(i) % texts.size()]);
}

void InThreads(const Texts& texts, int workers, int count) {
  std::vector<std::thread> threads;
  for (int i = 0; i < workers; ++i) threads.emplace_back(Load, std::cref(texts), count / workers);
  for (std::thread& thread : threads) thread.join();
}

void InProcesses(const Texts& texts, int workers, int count) {
  for (int i = 0; i < workers; ++i) {
    if (fork() == 0) {
      Load(texts, count / workers);
      _exit(0);
    }
  }
  for (int i = 0; i < workers; ++i) {
    int status = 1;
    if (wait(&status) < 0 || status != 0) std::abort();
  }
}

template <typename Action>
double PerSecond(int count, const Action& action) {
  const auto start = std::chrono::steady_clock::now();
  action();
  return count / std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double Median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

int NumberOr(char** words, int count, int which, int otherwise) {
  return which < count ? std::max(1, std::atoi(words[which])) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  const int workers = NumberOr(argv, argc, 1, 2);
  const int count = NumberOr(argv, argc, 2, 4000);
  const int runs = NumberOr(argv, argc, 3, 5);
  fmt::print("MuJoCo {}, {} workers, models per second\n", mj_versionString(), workers);
  fmt::print("{:<28}{:>10}{:>10}{:>12}\n", "", "threads", "processes", "ratio");
  for (const char* spec : {"robosuite/hammer", "mug", "drawer_cabinet"}) {
    const Texts texts = mjforge::bench::Texts(mjforge::bench::Named(spec, {}).recipe, "", 64);
    std::vector<double> threads, processes, ratios;
    for (int run = 0; run < runs; ++run) {
      threads.push_back(PerSecond(count, [&] { InThreads(texts, workers, count); }));
      processes.push_back(PerSecond(count, [&] { InProcesses(texts, workers, count); }));
      ratios.push_back(threads.back() / processes.back());
    }
    fmt::print("{:<28}{:>10.0f}{:>10.0f}{:>12.2f}\n", spec, Median(threads), Median(processes),
               Median(ratios));
  }
  return 0;
}
