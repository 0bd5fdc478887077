// An object with its start in a keyframe and with its start as zero configuration, compared in
// MuJoCo.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/engine/engine.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// Generates a variant of a spec with the setting `root.start`, for the target MuJoCo, and loads
/// its MJCF. Fails the test if a finding reports that the model that MuJoCo compiled differs from
/// the object.
struct StartForm {
  StartForm(const std::filesystem::path& file, const std::string& start, std::uint64_t index);

  Variant variant;
  engine::Model model;  // null if the variant failed
};

/// Compares both forms at the start and at 19 random states near it: poses of everything, lengths
/// and forces of actuators and tendons, passive forces, residuals of limits and equalities, and
/// sensors of positions and velocities. Fails the test if a number differs by more than `tolerance`
/// times the largest in its array (or 1). Returns the number of compared numbers.
int CompareStartForms(const mjModel& keyframe, const mjModel& zero, double tolerance);

}  // namespace mjforge::forge
