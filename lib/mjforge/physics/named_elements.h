// Names of bodies, joints and sites in checks, as written in the spec or in the file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Check in a spec that names bodies or sites, and its place for findings.
struct NamingCheck {
  std::string_view key;  // key of the check in the spec: "fits"
  diag::SourceMark mark;
};

/// Returns the name of an element without the prefix "OBJECT_", where OBJECT is the name of the
/// object.
std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object);

/// Returns the names, without the prefix "OBJECT_", of all bodies (except the world), all joints,
/// or all sites of the object, depending on `kind`. Leaves out the names of probe bodies, and of
/// their joints and sites.
std::vector<std::string> OwnNames(const mjModel& m, mjtObj kind, std::string_view object);

/// Returns the id of the body, joint or site (`kind`) with this name; the prefix "OBJECT_" may be
/// missing. Returns nullopt if there is no such element.
std::optional<int> IdOf(const mjModel& m, mjtObj kind, std::string_view object,
                        const std::string& name);

/// Returns the id of the body or site (`kind`) with this name, like IdOf(). If there is none, adds
/// an error at the place of `check`, and returns nullopt.
std::optional<int> FindNamed(const ProbeTest& test, mjtObj kind, const std::string& name,
                             const NamingCheck& check);

/// Returns X_WS, the pose of a site in the world. Needs the poses that mj_kinematics computes.
model::Pose SitePose(const mjData& d, int site);

}  // namespace mjforge::physics
