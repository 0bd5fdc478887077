// Requirements on an object besides loading in MuJoCo: `checks:` and `expect:` of its spec.

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

/// Containment: balls dropped into the object must stay inside.
struct HoldingCheck {
  Eigen::Vector2d ball = {0.008, 0.008};  // m, diameters of the smallest and the largest ball
  int balls = 5;
  double drop = 0.1;                  // m, height of the lowest ball above the object
  std::optional<Eigen::Vector2d> at;  // m, world x, y of the drop; default: middle of bounding box
  std::string without;                // body that is removed first, such as a lid; empty: none
  bool empties = true;                // the balls must come out when the object is turned over
  diag::SourceMark mark;

  bool operator==(const HoldingCheck&) const = default;
};

/// Free bodies must stay where they start.
struct SettlingCheck {
  double time = 2;                     // s, simulated
  double moved = 0.002;                // m, largest motion of the centre of mass
  double turned = 0.0349065850398866;  // rad
  diag::SourceMark mark;

  bool operator==(const SettlingCheck&) const = default;
};

/// Peg in hole: a peg or a free body must go into a hole.
struct FittingCheck {
  std::string hole;  // site at the mouth of the hole, whose z axis points into the hole
  /// Free body whose site `tip` is laid on the hole's site; empty for a peg.
  std::string body;
  std::string tip;
  std::array<double, 2> peg = {};  // m, full sides; a round peg has its diameter twice
  bool is_round = true;
  double depth = 0;  // m, required depth of the tip
  diag::SourceMark mark;

  bool operator==(const FittingCheck&) const = default;
};

/// Grasps: a gripper with two parallel jaws must hold the object.
struct GraspingCheck {
  std::vector<std::string> sites = {};  // empty: the sites that the manual lists
  double width = 0.08;                  // m, largest distance of the jaws
  double force = 30;                    // N, closing force
  double pull = 5;                      // N, resistance of the joint of a part that is held
  int tries = 3;                        // attempts at each site
  diag::SourceMark mark = {};

  bool operator==(const GraspingCheck&) const = default;
};

/// Limits for some parts, in place of the limits of Checks.
struct PartCheck {
  std::vector<std::string> parts = {};
  // Limits; if a limit is nullopt, the member of Checks with the same name applies.
  std::optional<Eigen::Vector2d> density = {};
  std::optional<double> thickness = {};
  std::optional<double> aspect = {};
  diag::SourceMark mark = {};

  bool operator==(const PartCheck&) const = default;
};

/// Limits for some joints, driven or at rest, in place of the limits of Checks. Names are written
/// as in the spec, without the object's prefix.
struct JointCheck {
  std::vector<std::string> joints = {};  // joints to drive at the same time
  /// Positions of other joints while `joints` are driven: rad or m; for a ball joint w, x, y, z.
  std::vector<std::pair<std::string, std::vector<double>>> positions = {};
  // Limits; if a limit is nullopt, Checks::joint_overshoot, joint_reach, ... apply.
  std::optional<double> overshoot = {};
  std::optional<double> reach = {};
  std::optional<double> penetration = {};
  std::optional<double> joint_return = {};
  std::optional<Eigen::Vector2d> rests = {};  // allowed positions after the drop, rad or m
  std::string skip = {};                      // reason not to drive the joints; empty: drive them
  diag::SourceMark mark = {};

  bool operator==(const JointCheck&) const = default;
};

/// Thresholds of all checks, in SI units. The defaults are those of the field table
/// (spec/fields.cc).
struct Checks {
  bool simready = false;         // also run the tests of the SimReady benchmark
  double self_collision = 1e-5;  // m, largest overlap depth of two bodies, joints at zero
  // Limits for a drop on a floor.
  bool stable = false;                 // a tilt of more than `tilt` is an error
  double settle_time = 3;              // s
  double rest_speed = 0.01;            // m/s, below which the object is at rest
  double tilt = 0.2617993877991494;    // rad
  double nudge = 0.17453292519943295;  // rad, tilt of a stable object before it is let go
  double drift = std::numeric_limits<double>::infinity();        // m, motion along the floor
  double penetration = std::numeric_limits<double>::infinity();  // m, depth in the floor at landing
  double sink = 0.001;                                           // m, depth in the floor at rest
  double energy_gain = 0.02;                                     // share of mass * g * size
  std::optional<HoldingCheck> holds;
  std::optional<SettlingCheck> settled;
  std::vector<FittingCheck> fits;
  std::optional<GraspingCheck> grasps;
  // Limits for driven joints.
  bool drive = true;
  std::vector<JointCheck> joints;
  double joint_overshoot = 0.05;           // share of the range
  double joint_reach = 0.9;                // share of the range
  double joint_penetration = 0.001;        // m
  double joint_return = 0.05;              // share of the range
  double equality_error = 0.02;            // share of joint 1's travel, or of the object's size
  double hinge_range = 6.283185307179586;  // rad, widest range of an uncoupled hinge
  double slide_range = 3;                  // range of an uncoupled slide / object's longest side
  // Limits that are checked without a simulation.
  std::vector<PartCheck> parts;
  Eigen::Vector2d density = {20, 22'000};      // kg/m^3, lowest and highest of a part
  Eigen::Vector2d bulk_density = {1, 22'000};  // kg/m^3, mass of the object / bounding box
  double overlap = 0.05;                       // share of the mass
  double thickness = 0.001;                    // m, least thickness of a part
  double aspect = 100;                         // longest side of a part / shortest
  double gap = 0.0005;                         // m, largest gap between connected parts
  double look = 0.2;                           // visual shape beyond collision shape / body's size
  /// Findings to leave out: pairs of a finding's code and the reason for leaving it out.
  std::vector<std::pair<std::string, std::string>> silenced;

  bool operator==(const Checks&) const = default;
};

/// Required distance or contact of two bodies or parts, with joints at given positions.
struct Expectation {
  ExpectationKind kind = ExpectationKind::kGap;  // never kThat, which the assembly evaluates
  /// Full names of bodies, or of parts if no body has that name.
  std::string first;
  std::string second;
  std::optional<double> min;  // m, for kGap
  std::optional<double> max;
  /// Full names of joints, and positions as in qpos. Other joints are at their start position.
  std::vector<std::pair<std::string, sample::Numbers>> positions;
  std::string doc;  // reason for the requirement, for messages
  diag::SourceMark mark;
};

}  // namespace mjforge::model
