// Table of ratios with their goals, printed after the benchmarks.

#include "ratios.h"

#include <fmt/format.h>

namespace mjforge::bench {
namespace {

struct Ratio {
  const char* what;
  const char* numerator;
  const char* denominator;  // null: the ratio is the time itself, us
  double goal;              // upper limit
};

constexpr Ratio kRatios[] = {
    {"a hammer sampled, assembled and written, us", "BM_SampleAssembleWrite", nullptr, 20},
    {"a hammer with its manifest record, us", "BM_GenerateRecord", nullptr, 40},
    {"validated / bare load with tight sizes", "BM_GenerateValidated", "BM_LoadTight", 1.3},
    {"validated / bare load with default sizes", "BM_GenerateValidated", "BM_LoadDefault", 0.8},
    {"a lathe of 20 points, 48 segments, with record, us", "BM_Lathe", nullptr, 150},
    {"a tube with two bends, with record, us", "BM_Tube", nullptr, 100},
    {"loading a mug / the mug of 66 geoms", "BM_LoadMug", "BM_LoadMugOfBoxes", 1},
    {"a drop / as many bare mj_step", "BM_Settle", "BM_BareSteps", 1.15},
    {"10,000 parts / 1,000 parts", "BM_Parts/10000", "BM_Parts/1000", 11},
    {"a list of 10,000 draws / of 1,000", "BM_List/10000", "BM_List/1000", 11},
    {"10,000 parameters read / 1,000", "BM_Parameters/10000", "BM_Parameters/1000", 12},
    {"a chain of 1,000 bodies / of 100", "BM_Chain/1000", "BM_Chain/100", 12},
    {"1,000 attached copies of a knob / 100", "BM_AttachedKnobs/1000", "BM_AttachedKnobs/100", 12},
    {"200 boxes placed on 30 % of a region, us", "BM_PlaceBoxes/200", nullptr, 50'000},
    {"100 boxes placed on ten times the area / 10", "BM_PlaceBoxes/100", "BM_PlaceBoxes/10", 12},
    {"1,000 attached copies of an arm / 100", "BM_AttachedArms/1000", "BM_AttachedArms/100", 12},
};

}  // namespace

void RatioReporter::ReportRuns(const std::vector<Run>& runs) {
  benchmark::ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
    const bool single = run.run_type == Run::RT_Iteration && run.repetitions <= 1;
    if (!median && !single) continue;
    medians_[run.run_name.function_name +
             (run.run_name.args.empty() ? "" : "/" + run.run_name.args)] =
        run.GetAdjustedCPUTime() * benchmark::GetTimeUnitMultiplier(benchmark::kMicrosecond) /
        benchmark::GetTimeUnitMultiplier(run.time_unit);
  }
}

void RatioReporter::Finalize() {
  benchmark::ConsoleReporter::Finalize();
  fmt::print("\n{:<48}{:>10}{:>10}\n", "medians of this run", "measured", "goal");
  for (const Ratio& ratio : kRatios) {
    const auto numerator = medians_.find(ratio.numerator);
    if (numerator == medians_.end()) continue;
    double value = numerator->second;
    if (ratio.denominator != nullptr) {
      const auto denominator = medians_.find(ratio.denominator);
      if (denominator == medians_.end()) continue;
      value /= denominator->second;
    }
    fmt::print("{:<48}{:>10.2f}{:>10}{}\n", ratio.what, value, fmt::format("<= {}", ratio.goal),
               value > ratio.goal ? "  not reached" : "");
  }
}

}  // namespace mjforge::bench
