// Named sets of values, in files beside the spec that --params reads.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"

namespace mjforge::customize {

/// Names of files: "lamp.tall.params.yaml" has the values `tall` of lamp.yaml.
class Presets {
 public:
  /// `folder` contains the files, and `stem` is the name of the spec's file without its ending.
  Presets(std::filesystem::path folder, std::string stem)
      : folder_(std::move(folder)), stem_(std::move(stem)) {}

  /// Returns true for names that a file can have: letters, digits, _ and -.
  static bool IsName(std::string_view name);
  /// Returns the names of the files that exist, sorted.
  std::vector<std::string> List() const;
  std::filesystem::path FileOf(std::string_view name) const;
  /// Writes the values. Returns false and adds a finding on failure, also if the file exists and
  /// was not written by this function.
  bool Save(std::string_view name, std::span<const spec::Setting> settings,
            diag::Findings& findings) const;

 private:
  std::filesystem::path folder_;
  std::string stem_;
};

}  // namespace mjforge::customize
