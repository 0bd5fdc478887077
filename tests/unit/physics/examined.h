// MJCF texts, loaded or examined by a Laboratory.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/temporary_folder.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// Loads a model with these sections; the test fails if MuJoCo rejects it.
inline engine::Model Load(const std::string& sections) {
  static engine::Engine engine;
  engine::Loaded loaded = engine.LoadText("<mujoco>" + sections + "</mujoco>");
  INFO(loaded.error);
  REQUIRE(loaded.model);
  return std::move(loaded.model);
}

struct Examined {
  std::optional<Result> result;
  diag::Findings findings;

  /// Severities and codes: "error physics/topples".
  std::vector<std::string> Codes() const {
    std::vector<std::string> codes;
    for (const diag::Finding& finding : findings) {
      const std::string severity =
          finding.severity == diag::Severity::kError ? "error " : "warning ";
      codes.push_back(severity + std::string(diag::CodeName(finding.code)));
    }
    return codes;
  }
};

/// Examines a file with these elements in its world, followed by these sections.
inline Examined Examine(const std::string& world, const std::string& sections = {},
                        const model::Checks& checks = {}) {
  static Laboratory laboratory;
  const mjforge::harness::TemporaryFolder folder;
  const auto file =
      folder.Write("m.xml", "<mujoco model=\"m\"><compiler angle=\"radian\"/><worldbody>" + world +
                                "</worldbody>" + sections + "</mujoco>");
  Examined examined;
  diag::Sources sources;
  examined.result = laboratory.Examine(file, checks, sources, examined.findings);
  return examined;
}

/// Returns a body with a free joint, at height `z`, with these elements.
inline std::string Free(double z, const std::string& content) {
  return "<body name=\"root\" pos=\"0 0 " + std::to_string(z) + "\"><freejoint name=\"free\"/>" +
         content + "</body>";
}

inline const std::string kCube = R"(<geom name="cube" type="box" size="0.05 0.05 0.05"/>)";

}  // namespace mjforge::physics
