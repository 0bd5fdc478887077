// Counts of passed and failed physics tests of a batch.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mjforge/physics/physics.h"

namespace mjforge::report {

/// A physics test, and its results over the batch.
struct TestTally {
  enum class Kind { kSimReady, kHolds, kSettled, kFits, kGrasps };
  Kind kind = Kind::kSimReady;
  std::string name;          // name of the test, or of the grasped site; empty without a site
  std::uint64_t passed = 0;  // number of variants
  std::uint64_t failed = 0;  // number of variants
  std::uint64_t ways = 0;    // attempted grasps of all variants
  std::uint64_t held = 0;    // successful grasps
};

/// Tests of a batch: the SimReady benchmark, containment, bodies that stay, pegs in holes, and
/// grasps. A variant counts neither as passed nor as failed if a test does not apply.
class TestTallies {
 public:
  /// Maximum number of tests; further sites are left out.
  static constexpr std::size_t kMost = 100;

  void Add(const physics::Result& result);
  void Append(const TestTallies& other);
  const std::vector<TestTally>& list() const { return list_; }

 private:
  void Count(TestTally::Kind kind, const std::string& name, bool passed);
  /// Finds or adds a test; returns null if there are kMost tests already.
  TestTally* FindOrAdd(TestTally::Kind kind, const std::string& name);
  void AddGrasps(const std::vector<physics::Result::Grasp>& grasps);

  std::vector<TestTally> list_;
};

}  // namespace mjforge::report
