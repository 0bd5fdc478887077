#pragma once

// What was tried with each variant, and how often it came out well.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mjforge/physics/physics.h"

namespace mjforge::report {

/// One thing that was tried.
struct Trial {
  enum class Kind { kSimReady, kHolds, kFits, kGrasps };
  Kind kind = Kind::kSimReady;
  std::string name;  // of the test; of the site that jaws close at, empty where there is none
  std::uint64_t passed = 0;  // variants
  std::uint64_t failed = 0;
  std::uint64_t ways = 0;  // to grasp, in all of them
  std::uint64_t held = 0;  // of those
};

/// The trials of a batch: tests of the SimReady benchmark, what is dropped in, what must fit, and
/// grasps. A variant that a test does not apply to has neither passed nor failed it.
class Trials {
 public:
  /// More sites than a page can show are left out.
  static constexpr std::size_t kMost = 100;

  void Add(const physics::Result& result);
  const std::vector<Trial>& list() const { return list_; }

 private:
  void Count(Trial::Kind kind, const std::string& name, bool passed);
  /// Null: there is no room for one more.
  Trial* Find(Trial::Kind kind, const std::string& name);
  void AddGrasps(const std::vector<physics::Result::Grasp>& grasps);

  std::vector<Trial> list_;
};

}  // namespace mjforge::report
