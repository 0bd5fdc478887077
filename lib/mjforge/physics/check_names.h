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

/// Check of a spec that names bodies or sites.
struct NamingCheck {
  std::string_view key;  // "fits"
  diag::SourceMark mark;
};

/// Returns an element's name without "OBJECT_" in front of it.
std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object);

/// Returns the names of all bodies (without the world), joints or sites, without "OBJECT_" in front
/// of them and without those of probe bodies.
std::vector<std::string> OwnNames(const mjModel& m, mjtObj kind, std::string_view object);

/// Returns the id of the body, joint or site (`kind`) with this name, with or without "OBJECT_" in
/// front of it; nothing if there is none.
std::optional<int> IdOf(const mjModel& m, mjtObj kind, std::string_view object,
                        const std::string& name);

/// Returns the id of the body or site (`kind`) as IdOf() does; nothing after a finding.
std::optional<int> FindNamed(const ProbeTest& test, mjtObj kind, const std::string& name,
                             const NamingCheck& check);

/// Returns X_WS of a site, as mj_kinematics computed it.
model::Pose SitePose(const mjData& d, int site);

}  // namespace mjforge::physics
