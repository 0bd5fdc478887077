// Requirements on an object in addition to loading in MuJoCo: `checks:` and `expect:` of its spec.

#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

namespace mjforge::model {

// Aliases for libraries that must not use namespace `spec`.
using spec::ExpectationKind;
using spec::StartForm;

/// Containment: balls that are dropped into the object must stay inside it.
struct HoldingCheck {
  Eigen::Vector2d ball = {0.008, 0.008};  // m, diameters of the smallest and the largest ball
  int balls = 5;
  double drop = 0.1;                  // m, height of the lowest ball above the object
  std::optional<Eigen::Vector2d> at;  // m, world x, y of the drop; default: middle of bounding box
  std::string without;                // body removed before the test, such as a lid; empty: none
  bool empties = true;  // the balls must leave the object when it is turned upside down
  diag::SourceMark mark;

  bool operator==(const HoldingCheck&) const = default;
};

/// Settling: free bodies must stay where they start.
struct SettlingCheck {
  double time = 2;                     // s, simulated
  double moved = 0.002;                // m, maximum displacement of the centre of mass
  double turned = 0.0349065850398866;  // rad, maximum rotation
  diag::SourceMark mark;

  bool operator==(const SettlingCheck&) const = default;
};

/// Peg in hole: a peg or a free body must go into a hole.
struct FittingCheck {
  std::string hole;  // site at the mouth of the hole, whose z axis points into the hole
  /// Free body, and its site `tip`, which is placed on the site of the hole; empty for a peg.
  std::string body;
  std::string tip;
  std::array<double, 2> peg = {};  // m, full sides; round peg: {diameter, diameter}
  bool is_round = true;
  double depth = 0;  // m, required depth of the tip
  diag::SourceMark mark;

  bool operator==(const FittingCheck&) const = default;
};

/// Grasps: a gripper with two parallel jaws must hold the object.
struct GraspingCheck {
  std::vector<std::string> sites = {};  // grasp sites; empty: those whose names begin with "grasp"
  double width = 0.08;                  // m, largest distance between the jaws
  double force = 30;                    // N, closing force
  double pull = 5;                      // N, force at the jaws when a joint pulls the held part
  int tries = 3;                        // number of attempts at each site
  diag::SourceMark mark = {};

  bool operator==(const GraspingCheck&) const = default;
};

/// Limits for some parts, which replace the limits of Checks.
struct PartCheck {
  std::vector<std::string> parts = {};
  // Limits. If a limit is nullopt, the member of Checks with the same name applies.
  std::optional<Eigen::Vector2d> density = {};
  std::optional<double> thickness = {};
  std::optional<double> aspect = {};
  diag::SourceMark mark = {};

  bool operator==(const PartCheck&) const = default;
};

/// Limits for some joints, driven or at rest, which replace the limits of Checks. Names are written
/// as in the spec, without the object's prefix.
struct JointCheck {
  std::vector<std::string> joints = {};  // joints that are driven simultaneously
  /// Positions of other joints while `joints` are driven: rad or m; w, x, y, z for a ball joint.
  std::vector<std::pair<std::string, std::vector<double>>> positions = {};
  // Limits. If a limit is nullopt, Checks::joint_overshoot, joint_reach, ... apply.
  std::optional<double> overshoot = {};
  std::optional<double> reach = {};
  std::optional<double> penetration = {};
  std::optional<double> joint_return = {};
  std::optional<Eigen::Vector2d> rests = {};  // allowed positions after the drop, rad or m
  std::string skip = {};  // reason for not driving the joints; empty: they are driven
  diag::SourceMark mark = {};

  bool operator==(const JointCheck&) const = default;
};

/// Thresholds of all checks, in SI units. The defaults are those of the field table
/// (spec/fields.cc).
struct Checks {
  bool simready = false;         // also run the tests of the SimReady benchmark
  double self_collision = 1e-5;  // m, largest overlap depth of two bodies with all joints at zero
  // Limits for a drop on a floor.
  bool stable = false;                 // true: a tilt of more than `tilt` is an error
  double settle_time = 3;              // s, after which the object must be at rest
  double rest_speed = 0.01;            // m/s, below this speed the object is at rest
  double tilt = 0.2617993877991494;    // rad, largest tilt of a stable object
  double nudge = 0.17453292519943295;  // rad, initial tilt of a stable object before its release
  double drift = std::numeric_limits<double>::infinity();  // m, largest motion along the floor
  // Largest penetration into the floor at landing, m.
  double penetration = std::numeric_limits<double>::infinity();
  double sink = 0.001;        // m, largest penetration into the floor at rest
  double energy_gain = 0.02;  // largest gain of energy / (mass * g * size)
  std::optional<HoldingCheck> holds;
  std::optional<SettlingCheck> settled;
  std::vector<FittingCheck> fits;
  std::optional<GraspingCheck> grasps;
  // Limits for driven joints.
  bool drive = true;
  std::vector<JointCheck> joints;
  double joint_overshoot = 0.05;           // largest distance beyond the range / range
  double joint_reach = 0.9;                // smallest share of the range that is reached
  double joint_penetration = 0.001;        // m, largest penetration of bodies
  double joint_return = 0.05;              // largest distance of end from start / range
  double equality_error = 0.02;            // largest error / travel of joint 1 or object's size
  double hinge_range = 6.283185307179586;  // rad, widest range of an uncoupled hinge
  double slide_range = 3;                  // widest range of an uncoupled slide / longest side
  // Limits that are checked without a simulation.
  std::vector<PartCheck> parts;
  Eigen::Vector2d density = {20, 22'000};      // kg/m^3, lowest and highest density of a part
  Eigen::Vector2d bulk_density = {1, 22'000};  // kg/m^3, lowest and highest: mass / box volume
  double overlap = 0.05;                       // largest mass of overlaps of parts / body's mass
  double thickness = 0.001;                    // m, least thickness of a part
  double aspect = 100;  // largest ratio of a part's longest and shortest side
  double gap = 0.0005;  // m, largest gap between parts that are connected
  double look = 0.2;    // largest distance of visual beyond collision shape / body's size
  /// Silenced findings: code of each finding, and the reason why it is silenced.
  std::vector<std::pair<std::string, std::string>> silenced;

  bool operator==(const Checks&) const = default;
};

/// Required distance or contact of two bodies or parts, with some joints at given positions.
struct Expectation {
  ExpectationKind kind = ExpectationKind::kGap;  // never kThat, which the assembler evaluates
  /// Full names of two bodies; a name that no body has is the name of a part.
  std::string first;
  std::string second;
  std::optional<double> min;  // m, for kGap
  std::optional<double> max;
  /// Full names of joints, and their positions as in qpos. All other joints are at their start.
  std::vector<std::pair<std::string, sample::Numbers>> positions;
  std::string doc;  // reason for the requirement, for messages
  diag::SourceMark mark;
};

}  // namespace mjforge::model
