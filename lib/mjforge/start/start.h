// The start state of an object as MuJoCo's zero configuration (qpos0), at which mj_resetData,
// attached copies and most programs begin.
#pragma once

#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::start {

/// An element whose meaning would change if the zero configuration (qpos0) were moved to the start:
/// the element depends on qpos0 in a way that MJCF cannot state, or through numbers that only
/// MuJoCo computes.
struct Obstacle {
  diag::SourceMark mark;
  std::string reason;
  std::string remedy;  // change of the element that avoids the obstacle; empty if there is none
};

/// Returns the obstacles of an object; none if MoveZeroToStart() keeps the meaning of all elements.
std::vector<Obstacle> FindObstacles(const model::Object& object);

/// Adds a finding for each active equality (joint, connect or weld) that the start violates by more
/// than 0.1 mm or 0.1 degrees. Ignores equalities of joints without a start position, and of bodies
/// that the start does not move relative to each other.
void CheckEqualities(const model::Object& object, diag::Findings& findings);

/// Rewrites an object without obstacles so that its zero configuration is its start: poses of
/// bodies, axes, anchors and `ref` of joints, and everything that MuJoCo measures from qpos0.
/// Positions of hinges and slides keep their meaning. The start position of each ball joint is
/// removed, because it becomes the joint's zero. Changes nothing if all joints start at zero.
void MoveZeroToStart(model::Object& object);

}  // namespace mjforge::start
