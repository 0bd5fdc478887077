#pragma once

// What checks call by the names of the spec or of the file.

#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Where a check of the spec stands.
struct CheckPlace {
  std::string_view check;  // "fits"
  diag::SourceMark mark;
};

/// A name without "OBJECT_" in front of it.
std::string OwnName(const mjModel& m, mjtObj kind, int id, std::string_view object);

/// Number of a body or site (`kind`) that is named as in the spec or in the file; -1 after a
/// finding.
int FindNamed(const mjModel& m, mjtObj kind, std::string_view object, const std::string& own,
              const CheckPlace& place, Verdict& verdict);

/// X_WS of a site, as mj_kinematics left it.
model::Pose SitePose(const mjData& d, int site);

}  // namespace mjforge::physics
