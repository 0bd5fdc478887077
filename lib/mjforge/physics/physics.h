#pragma once

// Checks whether an object behaves: drops it on a floor, drives its joints, and compares its
// numbers with those of real things. Uses MuJoCo 2.2.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// What was measured, in SI units, rounded to four digits.
struct Result {
  /// One joint driven to both ends of its range and back, the root held, without gravity.
  struct Joint {
    std::string name;
    double overshoot = 0;     // beyond its range, rad or m
    double reach = 1;         // share of its range that it could be driven to
    double penetration = 0;   // deepest of two bodies, beyond where they start, m
    double return_error = 0;  // distance from where it began, rad or m
    bool operator==(const Joint&) const = default;
  };
  /// How far it can be tilted from where it rests, in any direction, before it topples.
  struct Stability {
    double angle = 0;   // rad
    double energy = 0;  // J, to get there
    bool operator==(const Stability&) const = default;
  };
  /// Balls dropped into the object, which is held, and turned over.
  struct Holding {
    int balls = 0;
    int held = 0;     // for 3 s
    int emptied = 0;  // of those, through the mouth as it was turned over; 0 if it was not
    bool operator==(const Holding&) const = default;
  };
  /// Pegs and bodies that were to go into holes.
  struct Fitting {
    int tried = 0;
    int fit = 0;
    bool operator==(const Fitting&) const = default;
  };
  /// One way to hold the object with two parallel jaws.
  struct Grasp {
    std::string site;  // where; empty: found where there is no site
    std::string body;  // what they close on
    /// The frame of the jaws in the body's: the middle between them, m; they close along y, their
    /// fingers point along z. A unit quaternion, w first.
    Eigen::Vector3d pos = Eigen::Vector3d::Zero();
    std::vector<double> quat = {1, 0, 0, 0};
    double width = 0;   // m, of what is between them
    bool held = false;  // as it was lifted and shaken, and for 2 s
    bool operator==(const Grasp&) const = default;
  };
  /// The tests of the SimReady benchmark: "pass", "fail", or "skipped" where they do not apply.
  struct SimReady {
    std::string ground_drop = "skipped";
    std::string slope_drop = "skipped";
    std::string full_range_sweep = "skipped";
    std::string self_collision = "skipped";
    bool operator==(const SimReady&) const = default;
  };
  /// The drop: from 2 mm above the floor, until it rests or the time is up. An object that is fixed
  /// to the world only hangs there under its weight.
  bool dropped = false;
  bool at_rest = false;
  double time = 0;         // simulated, s
  double drift = 0;        // of the centre of mass, along the floor, m
  double tilt = 0;         // angle between upwards before and after, rad
  double speed = 0;        // of the fastest point at the end, m/s
  double penetration = 0;  // deepest contact on the way: that of the hardest landing, m
  double sink = 0;         // deepest contact at the end, m
  double energy_gain = 0;  // most above the energy at the start, as a share of mass * g * size
  int ncon = 0;            // most contacts in a step
  int nefc = 0;            // most constraint rows in a step
  double overlap = 0;      // share of the mass that is counted twice
  std::vector<Joint> joints;
  std::optional<Stability> stability;  // none: it did not come to rest, or not alone on a floor
  std::optional<Holding> holds;        // none: not asked for
  std::optional<Fitting> fits;         // none: not asked for
  std::vector<Grasp> grasps;           // those that were tried, if that was asked for
  std::optional<SimReady> simready;    // none: not asked for
  bool operator==(const Result&) const = default;
};

/// Runs the simulations. Keeps MuJoCo's memory from one object to the next; make one per process.
class Laboratory {
 public:
  Laboratory();
  ~Laboratory();
  Laboratory(const Laboratory&) = delete;
  Laboratory& operator=(const Laboratory&) = delete;

  /// A document made from `object`, valid for MuJoCo. What violates object.checks is a finding at
  /// its place in the spec. If MuJoCo gives up, that is a finding and there is no result.
  std::optional<Result> Examine(const mjcf::MjcfDocument& document, const model::Object& object,
                                diag::Findings& findings);

  /// Any MJCF file that MuJoCo loads; findings point at its start. A model without a plane, in
  /// which something is free, gets a floor.
  std::optional<Result> Examine(const std::filesystem::path& file, const model::Checks& checks,
                                diag::Sources& sources, diag::Findings& findings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::physics
