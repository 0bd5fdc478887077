// Presets: named sets of parameter values, stored in files that the option --params reads.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Presets of a spec: the file lamp.tall.params.yaml is the preset `tall` of the spec lamp.yaml.
class Presets {
 public:
  /// `folder` is the folder of the presets; `stem` is the name of the spec's file without `.yaml`.
  Presets(std::filesystem::path folder, std::string stem)
      : folder_(std::move(folder)), stem_(std::move(stem)) {}

  /// Returns true if a preset can have this name: 1 to 60 letters, digits, _ and -.
  static bool IsValidName(std::string_view name);
  /// Returns the names of the presets that exist, sorted.
  std::vector<std::string> List() const;
  std::filesystem::path FileOf(std::string_view name) const;
  /// Writes the settings to the file of the preset `name`. Returns false, and adds a finding, if
  /// the file cannot be written, or exists and was not written by this function.
  bool Save(std::string_view name, std::span<const spec::Setting> settings,
            diag::Findings& findings) const;

 private:
  std::filesystem::path folder_;
  std::string stem_;
};

}  // namespace mjforge::customize
