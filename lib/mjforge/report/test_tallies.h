// Counts of passed and failed physics tests of a batch.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mjforge/physics/physics.h"

namespace mjforge::report {

/// A physics test, and its results in a batch.
struct TestTally {
  enum class Kind { kSimReady, kHolds, kSettled, kFits, kGrasps };
  Kind kind = Kind::kSimReady;
  std::string name;          // name of the test; for kGrasps, of the site, or empty without a site
  std::uint64_t passed = 0;  // number of variants
  std::uint64_t failed = 0;  // number of variants
  std::uint64_t ways = 0;    // attempted grasps of all variants
  std::uint64_t held = 0;    // successful grasps
};

/// Results of the tests of a batch: the SimReady benchmark, containment, settling of free bodies,
/// pegs in holes, and grasps. A variant to which a test does not apply counts neither as passed nor
/// as failed.
class TestTallies {
 public:
  /// Maximum number of tests; further grasp sites are ignored.
  static constexpr std::size_t kMost = 100;

  void Add(const physics::Result& result);
  void Append(const TestTallies& other);
  const std::vector<TestTally>& list() const { return list_; }

 private:
  void Count(TestTally::Kind kind, const std::string& name, bool passed);
  /// Returns a test; adds the test if it is missing. Returns null if it is missing and there are
  /// kMost others.
  TestTally* FindOrAdd(TestTally::Kind kind, const std::string& name);
  void AddGrasps(const std::vector<physics::Result::Grasp>& grasps);

  std::vector<TestTally> list_;
};

}  // namespace mjforge::report
