#pragma once

// What an object must do and be, besides loading in MuJoCo: `checks:` and `expect:` of its spec.

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

/// The thresholds of checks, SI units. The defaults are those of the
/// field table.
struct Checks {
  double self_collision = 1e-5;  // m, of two bodies at the joints' zero
  // Dropped on a floor.
  bool stable = false;               // whether a tilt beyond `tilt` is an error
  double settle_time = 3;            // s, at most
  double rest_speed = 0.01;          // m/s; slower is at rest
  double tilt = 0.2617993877991494;  // rad
  double drift = std::numeric_limits<double>::infinity();        // m
  double penetration = std::numeric_limits<double>::infinity();  // m
  double sink = 0.001;                                           // m
  double energy_gain = 0.02;                                     // share of mass * g * size
  std::optional<Holding> holds;
  // Joints driven.
  double joint_overshoot = 0.05;     // share of the range
  double joint_reach = 0.9;          // share of the range
  double joint_penetration = 0.001;  // m
  double joint_return = 0.05;        // share of the range
  // Numbers.
  Eigen::Vector2d density = {20, 22'000};      // kg/m^3, of a part
  Eigen::Vector2d bulk_density = {1, 22'000};  // kg/m^3, of the whole in its box
  double overlap = 0.05;                       // share of the mass
  double thickness = 0.001;                    // m, of a part
  double aspect = 100;                         // longest to shortest side of a part
  double gap = 0.0005;                         // m, between parts that hold together
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
  std::optional<tape::Traced<double>> min;  // m, of a gap
  std::optional<tape::Traced<double>> max;
  /// By full names; joints that are not here are where they start.
  std::vector<std::pair<std::string, sample::Numbers>> positions;
  std::string doc;  // why
  diag::SourceMark mark;
};

}  // namespace mjforge::model
