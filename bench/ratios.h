// Reporter of Google Benchmark that prints ratios of medians.

#pragma once

#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

namespace mjforge::bench {

/// Prints Google Benchmark's console table, followed by ratios of medians. Claims are based on
/// these ratios, because both medians come from one run on one machine.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  std::map<std::string, double> medians_;  // us of CPU time
};

}  // namespace mjforge::bench
