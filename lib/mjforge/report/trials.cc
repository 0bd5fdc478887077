// Counts of passed and failed physics tests.

#include "mjforge/report/trials.h"

#include <algorithm>
#include <utility>

namespace mjforge::report {

void Trials::Add(const physics::Result& result) {
  if (result.simready) {
    const std::pair<const char*, std::string physics::Result::SimReady::*> tests[] = {
        {"ground_drop", &physics::Result::SimReady::ground_drop},
        {"slope_drop", &physics::Result::SimReady::slope_drop},
        {"full_range_sweep", &physics::Result::SimReady::full_range_sweep},
        {"self_collision", &physics::Result::SimReady::self_collision}};
    for (const auto& [name, member] : tests) {
      const std::string& outcome = *result.simready.*member;
      if (outcome == "pass" || outcome == "fail")
        Count(Trial::Kind::kSimReady, name, outcome == "pass");
    }
  }
  if (result.holds) Count(Trial::Kind::kHolds, "holds", result.holds->held == result.holds->balls);
  if (result.settled) Count(Trial::Kind::kSettled, "settled", result.settled->moved == 0);
  if (result.fits) Count(Trial::Kind::kFits, "fits", result.fits->fit == result.fits->tried);
  AddGrasps(result.grasps);
}

void Trials::Append(const Trials& other) {
  for (const Trial& more : other.list_) {
    Trial* trial = Find(more.kind, more.name);
    if (trial == nullptr) continue;
    trial->passed += more.passed;
    trial->failed += more.failed;
    trial->ways += more.ways;
    trial->held += more.held;
  }
}

// A grasp at a site passes if any way to hold the object succeeds.
void Trials::AddGrasps(const std::vector<physics::Result::Grasp>& grasps) {
  std::vector<std::pair<std::string, bool>> sites;
  for (const physics::Result::Grasp& grasp : grasps) {
    auto site = std::ranges::find(sites, grasp.site, &std::pair<std::string, bool>::first);
    if (site == sites.end()) site = sites.insert(sites.end(), {grasp.site, false});
    site->second = site->second || grasp.held;
    Trial* trial = Find(Trial::Kind::kGrasps, grasp.site);
    if (trial == nullptr) continue;
    ++trial->ways;
    if (grasp.held) ++trial->held;
  }
  for (const auto& [site, held] : sites) Count(Trial::Kind::kGrasps, site, held);
}

void Trials::Count(Trial::Kind kind, const std::string& name, bool passed) {
  Trial* trial = Find(kind, name);
  if (trial != nullptr) ++(passed ? trial->passed : trial->failed);
}

Trial* Trials::Find(Trial::Kind kind, const std::string& name) {
  const auto is_it = [&](const Trial& trial) { return trial.kind == kind && trial.name == name; };
  auto found = std::ranges::find_if(list_, is_it);
  if (found != list_.end()) return &*found;
  if (list_.size() >= kMost) return nullptr;
  const auto after = std::ranges::upper_bound(list_, kind, {}, &Trial::kind);
  return &*list_.insert(after, {.kind = kind, .name = name});
}

}  // namespace mjforge::report
