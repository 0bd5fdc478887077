// Simulated tests of an object or an MJCF file: drops, driven joints, containment, bodies that stay
// where they start, peg in hole, grasps, and the SimReady benchmark.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/physics/pile.h"

namespace mjforge::physics {

/// Measurements of the simulated tests of one object, in SI units; numbers are rounded to four
/// digits.
struct Result {
  /// A joint that is driven to both ends of its range and back, without gravity, while free bodies
  /// are held in place.
  struct Joint {
    std::string name;
    double overshoot = 0;    // largest distance beyond the range of the joint, rad or m
    double reach = 1;        // share of the range that the joint reached, 0 to 1
    double penetration = 0;  // m, deepest penetration of two bodies, minus their depth at the start
    double return_error = 0;  // final distance from the start, rad or m
    bool operator==(const Joint&) const = default;
  };
  /// An equality constraint while the joints that it couples are driven, with gravity.
  struct Equality {
    std::string name;
    double error = 0;  // largest error, m or rad
    /// Error as a share of the travel of joint 1 (equality of two joints) or of the model's size.
    double share = 0;
    bool operator==(const Equality&) const = default;
  };
  /// Static stability of the resting object: the least tilt, in any direction, at which the object
  /// topples.
  struct Stability {
    double angle = 0;   // rad
    double energy = 0;  // J, least energy that topples the object
    bool operator==(const Stability&) const = default;
  };
  /// Containment test: balls dropped into the object, which is held and then turned over.
  struct Holding {
    int balls = 0;
    int held = 0;     // balls that stayed inside for 3 s
    int emptied = 0;  // balls of `held` that then left through the mouth; 0 if not turned over
    bool operator==(const Holding&) const = default;
  };
  /// Settling test: free bodies are simulated from their start for checks.settled->time.
  struct Settling {
    int bodies = 0;
    int moved = 0;        // bodies that moved or turned beyond the limits of checks.settled
    double distance = 0;  // m, largest displacement of a centre of mass
    double angle = 0;     // rad, largest rotation
    bool operator==(const Settling&) const = default;
  };
  /// Peg-in-hole test: numbers of pegs and bodies that were tried and that fit.
  struct Fitting {
    int tried = 0;
    int fit = 0;
    bool operator==(const Fitting&) const = default;
  };
  /// A grasp of the object by a gripper with two parallel jaws.
  struct Grasp {
    std::string site;  // name of the site; empty: the object has no site for grasps
    std::string body;  // name of the body with the face on the gripper's +y side
    /// Pose of the gripper in the body's frame. The origin is the midpoint between the jaws, m; the
    /// jaws close along y, and the fingers point along z. `quat` is a unit quaternion, w first.
    Eigen::Vector3d pos = Eigen::Vector3d::Zero();
    std::vector<double> quat = {1, 0, 0, 0};
    double width = 0;   // m, distance between the two faces
    bool held = false;  // the grasp held while the object was lifted and shaken or pulled
    bool operator==(const Grasp&) const = default;
  };
  /// Tests of the SimReady benchmark: "pass", "fail", or "skipped" if they do not apply.
  struct SimReady {
    std::string ground_drop = "skipped";
    std::string slope_drop = "skipped";
    std::string full_range_sweep = "skipped";
    std::string self_collision = "skipped";
    bool operator==(const SimReady&) const = default;
  };
  /// Results of the drop test, from `dropped` to `nefc`: the object falls from 2 mm above the floor
  /// and is simulated until it rests or checks.settle_time is over. An object fixed to the world is
  /// not dropped, but is simulated under its weight.
  bool dropped = false;
  bool at_rest = false;
  double time = 0;         // simulated time, s
  double drift = 0;        // displacement of the centre of mass along the floor, m
  double tilt = 0;         // rad, angle between the object's up directions before and after
  double speed = 0;        // speed of the fastest point at the end, m/s
  double penetration = 0;  // deepest contact during the drop, usually at a landing, m
  double sink = 0;         // deepest contact at the end, m
  double energy_gain = 0;  // largest gain since the start, as a share of mass * g * size
  int ncon = 0;            // largest number of contacts in a step
  int nefc = 0;            // largest number of constraint rows in a step
  double overlap = 0;      // share of the mass that overlapping parts count twice
  std::vector<Joint> joints;
  std::vector<Equality> equalities;
  std::optional<Stability> stability;  // set if one object rests alone on a level floor
  // Results of tests that run only if the checks ask for them.
  std::optional<Holding> holds;
  std::optional<Settling> settled;
  std::optional<Fitting> fits;
  std::vector<Grasp> grasps;  // all grasps that were tried
  std::optional<SimReady> simready;
  bool operator==(const Result&) const = default;
};

/// A simulated test for a film: positions (MuJoCo's qpos) at equal intervals of time, and the total
/// time, s.
struct Film {
  std::vector<std::vector<double>> positions;
  double time = 0;
};

/// Runs the simulated tests. Reuses the memory of mjData for the next object; a process needs only
/// one Laboratory.
class Laboratory {
 public:
  Laboratory();
  ~Laboratory();

  /// Tests a valid document made from `object`. Adds a finding, at its place in the spec, for each
  /// violation of object.checks. If MuJoCo fails, adds a finding and returns nullopt.
  std::optional<Result> Examine(const mjcf::MjcfDocument& document, const model::Object& object,
                                diag::Findings& findings);

  /// Simulates the drop of an object or, unless `joint` is empty, the drive of that joint, like
  /// Examine(), and returns at most `frames` positions. The document must be complete: a program
  /// that loads it must not have to add a free joint. If the drop or drive is impossible, adds a
  /// finding and returns nullopt.
  std::optional<Film> Record(const mjcf::MjcfDocument& document, const model::Object& object,
                             const std::string& joint, std::size_t frames,
                             diag::Findings& findings);

  /// Tests any MJCF file that MuJoCo loads; findings point at the start of the file. A model with
  /// free bodies but without a plane gets a floor.
  std::optional<Result> Examine(const std::filesystem::path& file, const model::Checks& checks,
                                diag::Sources& sources, diag::Findings& findings);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mjforge::physics
