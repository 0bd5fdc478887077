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
  double drop = 0.1;                  // m, height of the lowest ball above the object's top
  std::optional<Eigen::Vector2d> at;  // m, world x, y of the drop; default: middle of bounding box
  std::string without;                // body that does not collide in the test (a lid); empty: none
  bool empties = true;  // the balls must leave the object when it is turned upside down
  diag::SourceMark mark;

  bool operator==(const HoldingCheck&) const = default;
};

/// Settling: free bodies must stay where they start.
struct SettlingCheck {
  double time = 2;                     // s, simulated time
  double moved = 0.002;                // m, maximum displacement of a body's centre of mass
  double turned = 0.0349065850398866;  // rad, maximum rotation of a body
  diag::SourceMark mark;

  bool operator==(const SettlingCheck&) const = default;
};

/// Peg in hole: a peg or a free body must go into a hole.
struct FittingCheck {
  std::string hole;  // site at the mouth of the hole, whose z axis points into the hole
  /// Name of a free body, and of the body's site that is placed on the site of the hole before the
  /// body is released; empty names if the test uses a peg.
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
  double pull = 5;                      // N, force at the jaws when a joint pulls at the held part
  int tries = 3;                        // number of different grasps tried at each site
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
  // Limits. If one of the first four is nullopt, the limit `joint_...` of Checks applies.
  std::optional<double> overshoot = {};
  std::optional<double> reach = {};
  std::optional<double> penetration = {};
  std::optional<double> joint_return = {};
  std::optional<Eigen::Vector2d> rests = {};  // lowest, highest position after the drop, rad or m
  std::string skip = {};  // reason for not driving the joints; empty: they are driven
  diag::SourceMark mark = {};

  bool operator==(const JointCheck&) const = default;
};

/// Thresholds of all checks, in SI units. The defaults are those of the field table
/// (spec/fields.cc).
struct Checks {
  bool simready = false;         // also run the tests of the SimReady benchmark
  double self_collision = 1e-5;  // m, largest overlap depth of two bodies at the start
  // Limits for a drop on a floor.
  bool stable = false;                 // true: a tilt of more than `tilt` is an error
  double settle_time = 3;              // s, after which the object must be at rest
  double rest_speed = 0.01;            // m/s; at rest, the fastest body is slower than this
  double tilt = 0.2617993877991494;    // rad, largest tilt of a stable object
  double nudge = 0.17453292519943295;  // rad, initial tilt of a stable object before its release
  double drift = std::numeric_limits<double>::infinity();  // m, largest motion along the floor
  // Largest depth of any contact during the drop, m.
  double penetration = std::numeric_limits<double>::infinity();
  double sink = 0.001;        // m, largest depth of any contact at rest
  double energy_gain = 0.02;  // largest gain of energy, as a share of mass * gravity * size
  std::optional<HoldingCheck> holds;
  std::optional<SettlingCheck> settled;
  std::vector<FittingCheck> fits;
  std::optional<GraspingCheck> grasps;
  // Limits for driven joints.
  bool drive = true;
  std::vector<JointCheck> joints;
  double joint_overshoot = 0.05;     // largest distance beyond the range, as a share of the range
  double joint_reach = 0.9;          // smallest share of its range that a joint must reach
  double joint_penetration = 0.001;  // m, largest penetration of two bodies of the object
  double joint_return = 0.05;        // largest error when a joint returns, as a share of its range
  // Largest error of an equality, as a share of the travel of its first joint; for an equality of
  // bodies, as a share of the object's size.
  double equality_error = 0.02;
  // Widest ranges of joints that no equality or tendon couples: of a hinge, rad; of a slide, as a
  // multiple of the object's longest side.
  double hinge_range = 6.283185307179586;
  double slide_range = 3;
  // Limits that are checked without a simulation.
  std::vector<PartCheck> parts;
  Eigen::Vector2d density = {20, 22'000};      // kg/m^3, lowest and highest density of a part
  Eigen::Vector2d bulk_density = {1, 22'000};  // kg/m^3, lowest and highest mass / box volume
  double overlap = 0.05;                       // largest share of a body's mass that counts twice
  double thickness = 0.001;                    // m, least thickness of a part
  double aspect = 100;  // largest ratio of a part's longest and shortest side
  double gap = 0.0005;  // m, largest distance of parts that count as connected
  double look = 0.2;    // largest gap between sides of visual and collision bounds / body's size
  /// Pairs of the code of a silenced finding and the reason why it is silenced.
  std::vector<std::pair<std::string, std::string>> silenced;

  bool operator==(const Checks&) const = default;
};

/// Required relation of two bodies or parts (gap, contact, no overlap or containment), with some
/// joints at given positions.
struct Expectation {
  ExpectationKind kind = ExpectationKind::kGap;  // never kThat: the assembler evaluates conditions
  /// Full names of two bodies or parts. A body takes precedence over a part of the same name.
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
