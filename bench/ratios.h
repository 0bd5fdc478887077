#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace mjforge::bench {

/// Google Benchmark's console table, and after it the medians as ratios: those
/// are what a claim rests on, since they are of one run on one machine.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::map<std::string, double> medians_;  // us of CPU time
};

}  // namespace mjforge::bench
