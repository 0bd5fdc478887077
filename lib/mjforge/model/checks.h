#pragma once

// What an object must do and be, besides loading in MuJoCo: `checks:` and `expect:` of its spec.

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

using spec::ExpectationKind;  // for rooms to the right, which do not know specs

/// Balls dropped into the object.
struct Holding {
  Eigen::Vector2d ball = {0.008, 0.008};  // m, diameters of the smallest and the largest
  int balls = 5;
  double drop = 0.1;                  // m, above the object's highest point
  std::optional<Eigen::Vector2d> at;  // m, x, y in the world; none: in the middle of its box
  std::string without;                // a body that is taken away before; empty: none
  bool empties = true;                // whether they have to come out as it is turned over
  diag::SourceMark mark;

  bool operator==(const Holding&) const = default;
};

/// Something that has to go into a hole.
struct Fitting {
  std::string hole;  // a site, whose z axis is the way in
  /// A free body, whose site `tip` is laid on the hole's; empty: a peg.
  std::string body;
  std::string tip;
  std::array<double, 2> peg = {};  // m, full sides; or a diameter, twice
  bool is_round = true;
  double depth = 0;  // m, how far the tip has to get
  diag::SourceMark mark;

  bool operator==(const Fitting&) const = default;
};

/// How the object has to be held by two parallel jaws.
struct Grasping {
  std::vector<std::string> sites = {};  // none: as the manual says
  double width = 0.08;                  // m, how far apart the jaws can be
  double force = 30;                    // N, with which they close
  double pull = 5;                      // N, of a joint at jaws that hold what it moves
  int tries = 3;                        // at each site
  diag::SourceMark mark = {};

  bool operator==(const Grasping&) const = default;
};

/// What is asked of some parts in place of the usual.
struct PartCheck {
  std::vector<std::string> parts = {};
  // As in Checks; none: as there.
  std::optional<Eigen::Vector2d> density = {};
  std::optional<double> thickness = {};
  std::optional<double> aspect = {};
  diag::SourceMark mark = {};

  bool operator==(const PartCheck&) const = default;
};

/// What is asked of some joints, named as in the spec, in place of the usual, as they are driven
/// and as they rest.
struct JointCheck {
  std::vector<std::string> joints = {};  // driven at the same time
  /// Where others stand meanwhile: rad or m, of a ball joint w, x, y, z.
  std::vector<std::pair<std::string, std::vector<double>>> positions = {};
  // As in Checks; none: as there.
  std::optional<double> overshoot = {};
  std::optional<double> reach = {};
  std::optional<double> penetration = {};
  std::optional<double> joint_return = {};
  std::optional<Eigen::Vector2d> rests = {};  // where they may be after the drop, rad or m
  std::string skip = {};                      // why they are not driven; empty: they are
  diag::SourceMark mark = {};

  bool operator==(const JointCheck&) const = default;
};

/// The thresholds of checks, SI units. The defaults are those of the
/// field table.
struct Checks {
  bool simready = false;         // whether the tests of that benchmark are made, too
  double self_collision = 1e-5;  // m, of two bodies at the joints' zero
  // Dropped on a floor.
  bool stable = false;                 // whether a tilt beyond `tilt` is an error
  double settle_time = 3;              // s, at most
  double rest_speed = 0.01;            // m/s; slower is at rest
  double tilt = 0.2617993877991494;    // rad
  double nudge = 0.17453292519943295;  // rad, that a stable object is tilted by
  double drift = std::numeric_limits<double>::infinity();        // m
  double penetration = std::numeric_limits<double>::infinity();  // m
  double sink = 0.001;                                           // m
  double energy_gain = 0.02;                                     // share of mass * g * size
  std::optional<Holding> holds;
  std::vector<Fitting> fits;
  std::optional<Grasping> grasps;
  // Joints driven.
  bool drive = true;
  std::vector<JointCheck> joints;
  double joint_overshoot = 0.05;           // share of the range
  double joint_reach = 0.9;                // share of the range
  double joint_penetration = 0.001;        // m
  double joint_return = 0.05;              // share of the range
  double hinge_range = 6.283185307179586;  // rad, of a hinge that nothing is coupled to
  double slide_range = 3;                  // share of the object's longest side, of such a slide
  // Numbers.
  std::vector<PartCheck> parts;
  Eigen::Vector2d density = {20, 22'000};      // kg/m^3, of a part
  Eigen::Vector2d bulk_density = {1, 22'000};  // kg/m^3, of the whole in its box
  double overlap = 0.05;                       // share of the mass
  double thickness = 0.001;                    // m, of a part
  double aspect = 100;                         // longest to shortest side of a part
  double gap = 0.0005;                         // m, between parts that hold together
  double look = 0.2;                           // share of a body's size, of seen from colliding
  /// Codes of findings to leave out, and why.
  std::vector<std::pair<std::string, std::string>> silenced;

  bool operator==(const Checks&) const = default;
};

/// How two bodies or parts are expected to lie, with joints at given positions.
struct Expectation {
  ExpectationKind kind = ExpectationKind::kGap;  // not kThat, which is checked already
  /// Full names of bodies or, where there is no body of that name, of parts.
  std::string first;
  std::string second;
  std::optional<double> min;  // m, of a gap
  std::optional<double> max;
  /// By full names; joints that are not here are where they start.
  std::vector<std::pair<std::string, sample::Numbers>> positions;
  std::string doc;  // why
  diag::SourceMark mark;
};

}  // namespace mjforge::model
