// Counting of passed and failed physics tests, by the results in the records.

#include "mjforge/report/test_tallies.h"

#include <algorithm>
#include <utility>

namespace mjforge::report {

void TestTallies::Add(const physics::Result& result) {
  if (result.simready) {
    const std::pair<const char*, std::string physics::Result::SimReady::*> tests[] = {
        {"ground_drop", &physics::Result::SimReady::ground_drop},
        {"slope_drop", &physics::Result::SimReady::slope_drop},
        {"full_range_sweep", &physics::Result::SimReady::full_range_sweep},
        {"self_collision", &physics::Result::SimReady::self_collision}};
    for (const auto& [name, member] : tests) {
      const std::string& outcome = *result.simready.*member;
      if (outcome == "pass" || outcome == "fail")
        Count(TestTally::Kind::kSimReady, name, outcome == "pass");
    }
  }
  if (result.holds)
    Count(TestTally::Kind::kHolds, "holds", result.holds->held == result.holds->balls);
  if (result.settled) Count(TestTally::Kind::kSettled, "settled", result.settled->moved == 0);
  if (result.fits) Count(TestTally::Kind::kFits, "fits", result.fits->fit == result.fits->tried);
  AddGrasps(result.grasps);
}

void TestTallies::Append(const TestTallies& other) {
  for (const TestTally& more : other.list_) {
    TestTally* test = FindOrAdd(more.kind, more.name);
    if (test == nullptr) continue;
    test->passed += more.passed;
    test->failed += more.failed;
    test->ways += more.ways;
    test->held += more.held;
  }
}

// A grasp at a site passes if any way to hold the object succeeds.
void TestTallies::AddGrasps(const std::vector<physics::Result::Grasp>& grasps) {
  std::vector<std::pair<std::string, bool>> sites;
  for (const physics::Result::Grasp& grasp : grasps) {
    auto site = std::ranges::find(sites, grasp.site, &std::pair<std::string, bool>::first);
    if (site == sites.end()) site = sites.insert(sites.end(), {grasp.site, false});
    site->second = site->second || grasp.held;
    TestTally* test = FindOrAdd(TestTally::Kind::kGrasps, grasp.site);
    if (test == nullptr) continue;
    ++test->ways;
    if (grasp.held) ++test->held;
  }
  for (const auto& [site, held] : sites) Count(TestTally::Kind::kGrasps, site, held);
}

void TestTallies::Count(TestTally::Kind kind, const std::string& name, bool passed) {
  TestTally* test = FindOrAdd(kind, name);
  if (test != nullptr) ++(passed ? test->passed : test->failed);
}

TestTally* TestTallies::FindOrAdd(TestTally::Kind kind, const std::string& name) {
  const auto is_it = [&](const TestTally& test) { return test.kind == kind && test.name == name; };
  auto found = std::ranges::find_if(list_, is_it);
  if (found != list_.end()) return &*found;
  if (list_.size() >= kMost) return nullptr;
  const auto after = std::ranges::upper_bound(list_, kind, {}, &TestTally::kind);
  return &*list_.insert(after, {.kind = kind, .name = name});
}

}  // namespace mjforge::report
