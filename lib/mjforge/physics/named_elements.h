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

/// Returns an element's name without the prefix "OBJECT_", which is the object's name.
std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object);

/// Returns the names of all bodies (except the world), joints or sites of the object, without the
/// prefix "OBJECT_". Names of probe bodies and of their elements are left out.
std::vector<std::string> OwnNames(const mjModel& m, mjtObj kind, std::string_view object);

/// Returns the id of the body, joint or site (`kind`) with this name, with or without the prefix
/// "OBJECT_"; nullopt if there is none.
std::optional<int> IdOf(const mjModel& m, mjtObj kind, std::string_view object,
                        const std::string& name);

/// Returns the id of the body or site (`kind`) like IdOf(). If the name is unknown, adds a finding
/// and returns nullopt.
std::optional<int> FindNamed(const ProbeTest& test, mjtObj kind, const std::string& name,
                             const NamingCheck& check);

/// Returns X_WS, the pose of a site in the world. Needs the poses of mj_kinematics.
model::Pose SitePose(const mjData& d, int site);

}  // namespace mjforge::physics
