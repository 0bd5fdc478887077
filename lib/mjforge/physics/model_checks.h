// Checks of the feet, joints, equalities, contacts and settling of a model: one function per check.
#pragma once

#include <span>

#include <mujoco/mujoco.h>

#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/model_under_test.h"

namespace mjforge::physics {

/// Warns of a part that is above the floor by more than 1 mm and by less than half of its own
/// height, while similar parts (sizes differ by at most a tenth) stand on the floor. Warns of an
/// object that would slide on a floor with a slope of checks.nudge. `root` is the root of the tree
/// of bodies to check. `d` has the state of this tree at rest, with poses and contacts, on a level
/// plane at `height`, m.
void CheckFeet(const ModelTest& test, const mjData& d, int root, double height);

/// Adds an error for each joint whose position in `d` is beyond its range, or outside of `rests` in
/// checks.joints. A joint may exceed its range by the share `joint_overshoot` of the range, plus 1
/// mm (slides) or 0.02 rad (hinges). At its present speed, a joint must also stay within `rests`
/// for 10 s.
void CheckJointRests(const ModelTest& test, const mjData& d);

/// Warns of two bodies whose contacts MuJoCo ignores, because of `exclude` or their contact bits,
/// and whose penetration at rest exceeds their penetration at the start by more than
/// `joint_penetration`. `rest` has the positions at rest (qpos, nq numbers). Leaves out a body and
/// its parent, because axles overlap their wheels. May throw std::exception.
void CheckRestsInside(const ModelTest& test, std::span<const mjtNum> rest);

/// Returns the longest range that a slide of the object should have, m: checks.slide_range times
/// the longest side of the object; infinite if the object has no size.
double LongestSlide(const model::Object& object, const model::Checks& checks);

/// Warns of hinges with a range above checks.hinge_range, and of slides with a range above
/// LongestSlide(). Leaves out joints that are coupled to other joints.
void CheckRanges(const ModelTest& test);

/// Warns of actuators of hinges and slides that have a gear of 0, that are too weak to hold their
/// joint somewhere in its range against weight, springs and friction, or (position servos) whose
/// control range goes far beyond the range of the joint. Warns of joints whose damping, dry
/// friction or armature is too large for a person and for their actuators. May throw
/// std::exception.
void CheckEfforts(const ModelTest& test);

/// Warns of bodies on hinges and slides that start more than 3 cm, or more than a quarter of their
/// own size, from all other bodies of their tree. Warns of joints that, at an end of their range,
/// move their bodies too far from the rest of the tree. For a slide, too far is more than 3 cm,
/// unless the slide lifts the bodies; for a hinge, more than the larger of 3 cm and a quarter of
/// the size of the bodies. Coupled and unlimited joints are checked only at the start. Compares
/// bounding boxes of all geoms, including visual geoms. May throw std::exception.
void CheckUnsupportedLinks(const ModelTest& test);

/// Warns of bodies that penetrate their parents by more than `joint_penetration` at the start, and
/// of joints that increase this depth by more than `joint_penetration`; MuJoCo ignores contacts
/// between parent and child. Tries 8 to 40 positions of each joint (of a ball joint, about each
/// axis), 2 mm apart if possible. Other joints are at their start positions, or at those that `at`
/// of an entry of checks.joints sets. May throw std::exception.
void CheckParents(const ModelTest& test);

/// Drives the joints that test active equalities, fills in result.equalities, and adds an error for
/// each equality whose relative error is above checks.equality_error. May throw std::exception.
void CheckEqualities(const ModelTest& test);

/// Runs the tests ground_drop 3.0.0, slope_drop, and full_range_sweep 1.4.0 of the families FET003
/// and FET022 of the SimReady Foundation's benchmark, and a further test, self_collision. Fills in
/// result.simready. Skips the drops if the model has no free bodies or no floor. `drives` has the
/// results of DriveJoints(). May throw std::exception.
void CheckSimReady(const ModelTest& test, const DriveResults& drives);

/// Warns of the colliding geom with the largest sliding friction if that friction is above 2 and
/// the friction cones of the model are pyramidal.
void CheckFrictionCones(const ModelTest& test);

/// Simulates the model from its start for checks.settled->time, and adds a finding for each free
/// body that moves or turns by more than the limits of checks.settled. If the root of the object is
/// free, the object is put on the floor, and motions are relative to the root. Fills in
/// result.settled. May enlarge the model's buffers for contacts. May throw std::exception.
void CheckSettled(const ModelTest& test);

}  // namespace mjforge::physics
