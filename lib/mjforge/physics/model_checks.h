// Checks of the feet, joints, equalities, contacts and settling of a model: one function per check.
#pragma once

#include <span>

#include <mujoco/mujoco.h>

#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/model_under_test.h"

namespace mjforge::physics {

/// Warns of a part that is above the floor by more than 1 mm and less than half of its own height,
/// while similar parts (sizes differ by at most a tenth) stand on the floor. Warns of an object
/// that would slide on a floor with a slope of checks.nudge. `d` has the state at rest of the tree
/// of bodies with this root, with poses and contacts, on a level plane at `height`, m.
void CheckFeet(const ModelTest& test, const mjData& d, int root, double height);

/// Reports joints whose positions in `d` are beyond their ranges, or outside `rests` of
/// checks.joints. Joints may exceed their range by the share `joint_overshoot` of the range, plus 1
/// mm (slides) or 0.02 rad (hinges). Joints must stay within `rests` for another 10 s if they keep
/// their present speed.
void CheckJointRests(const ModelTest& test, const mjData& d);

/// Warns of two bodies whose contact is ignored because of `exclude` or their contact bits, and
/// whose penetration at rest exceeds their penetration at the start by more than
/// `joint_penetration`. `rest` has the positions at rest (nq). A body and its parent are left out,
/// because axles overlap their wheels. May throw std::exception.
void CheckRestsInside(const ModelTest& test, std::span<const mjtNum> rest);

/// Returns the longest range that a slide of the object should have, m; infinite if the object has
/// no size.
double LongestSlide(const model::Object& object, const model::Checks& checks);

/// Warns of hinges with a range above checks.hinge_range, and of slides with a range above
/// checks.slide_range times the object's longest side, unless they are coupled to other joints.
void CheckRanges(const ModelTest& test);

/// Warns of actuators of hinges and slides that have a gear of 0, that are too weak to hold their
/// joint somewhere in its range against weight, springs and friction, or whose control range leads
/// a position servo far beyond the joint's range. Warns of joints whose damping, dry friction or
/// armature neither a person nor their actuators overcome. May throw std::exception.
void CheckEfforts(const ModelTest& test);

/// Warns of bodies on hinges and slides that start more than 3 cm, or more than a quarter of their
/// own size, from all other bodies of their tree. Warns of joints that, at an end of their range,
/// move their bodies away from the rest of the tree: a slide by more than 3 cm, unless it lifts the
/// bodies; a hinge by more than 3 cm and a quarter of the bodies' size. Coupled and unlimited
/// joints are checked only at the start. Compares bounding boxes of all geoms, including visual
/// geoms. May throw std::exception.
void CheckUnsupportedLinks(const ModelTest& test);

/// Drives the joints that equalities couple (DriveEqualities), writes result.equalities, and
/// reports errors above checks.equality_error. May throw std::exception.
void CheckEqualities(const ModelTest& test);

/// Runs the tests ground_drop 3.0.0, slope_drop, and full_range_sweep 1.4.0 of the families FET003
/// and FET022 of the SimReady Foundation's benchmark, and mjforge's own test self_collision. Fills
/// in result.simready. Skips the drops if the model has no free bodies or no floor. `drives` has
/// the results of DriveJoints(). May throw std::exception.
void CheckSimReady(const ModelTest& test, const DriveResults& drives);

/// Warns of the colliding geom with the most sliding friction, if that friction is above 2 and the
/// friction cones are pyramids.
void CheckFrictionCones(const ModelTest& test);

/// Simulates the model from its start for checks.settled->time, and adds a finding for each free
/// body that moves or turns by more than the limits of checks.settled. If the root of the object is
/// free, the object is put on the floor, and motions are relative to the root. Fills in
/// result.settled. May enlarge the model's buffers for contacts. May throw std::exception.
void CheckSettled(const ModelTest& test);

}  // namespace mjforge::physics
