// Drive test: each joint is driven through its range and back.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// Result of driving one joint through its range and back.
struct DrivenJoint {
  int joint = 0;
  double range = 0;  // rad or m, length of the joint's range
  Result::Joint measured;
  const model::JointCheck* check = nullptr;  // entry of checks.joints for the joint; null: none
  /// Names of the two bodies of the joint's tree that penetrate each other deepest; empty: none.
  std::string body1;
  std::string body2;
  double free_depth = 1e-4;  // m, deepest penetration of bodies of different trees, if above 1e-4
  std::pair<std::string, std::string> free_pair;  // names of the bodies with the depth free_depth
  double where = 0;                     // rad or m, joint position with the deepest penetration
  double outside = 0;                   // rad or m, distance of the start position from the range
  std::vector<double> equality_errors;  // largest error of each equality constraint, m or rad
  bool has_diverged = false;
};

/// Two bodies that penetrate each other before any joint is driven.
struct InitialPenetration {
  int body1 = 0;
  int body2 = 0;
  double depth = 0;                          // m
  const model::JointCheck* check = nullptr;  // entry whose `at` sets the pose; null: start pose
};

/// Results of driving all joints, and bodies that overlap before any joint is driven.
struct DriveResults {
  std::vector<DrivenJoint> joints;
  std::vector<InitialPenetration> initial_penetrations;
};

/// Drives one joint like DriveJoints(), together with the other joints of its entry in
/// checks.joints, and records the drive. Returns false if the joint cannot be driven.
bool RecordDrive(const mjModel& m, mjData& d, std::string_view object, const model::Checks& checks,
                 int joint, FilmRecorder& recorder);

/// Drives each hinge and slide from its start position (`compiled::StartOf`) to both ends of its
/// range and back, and a ball joint from its reference orientation (qpos0) about each of its axes.
/// A hinge without a range makes a full turn; slides without a range are left out. A force makes
/// the joint follow smooth moves of half a second or more. The force accounts for the inertia that
/// the joint moves, but not for obstacles. Free bodies are held in place, and so are other joints
/// unless they are coupled to the driven joint. There is no gravity and no floor, and joints have
/// no friction, springs or actuators. Drives joints at the same time if their bodies cannot get
/// near each other, or if one entry of checks.joints names the joints. `object` is the name of the
/// object, and `d` the data of the model. May throw std::exception.
DriveResults DriveJoints(const mjModel& m, mjData& d, std::string_view object,
                         const model::Checks& checks);

}  // namespace mjforge::physics
