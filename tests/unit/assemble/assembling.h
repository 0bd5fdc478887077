// Fixtures: objects assembled from YAML texts, their findings, temporary folders.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/assemble/assemble.h"

namespace mjforge::assemble {

/// Assembles a spec. The header (`mjforge: 1`, `name: thing`) is put before the text `body`, so
/// that the body's first line is line 3.
class Assembling {
 public:
  explicit Assembling(const std::string& body, std::uint64_t seed = 1, std::uint64_t index = 0,
                      const std::filesystem::path& folder = {},
                      const Assembler::Options& options = {}, model::Placer* placer = nullptr);

  /// Returns the object. The test fails with the findings if there is none.
  const model::Object& object() const;
  const model::Body& body() const { return object().bodies.front(); }
  const model::Part& part(const std::string& name) const;
  bool failed() const { return !object_; }
  /// Returns each finding as "line:column message", with " (hint)" if there is a hint.
  std::vector<std::string> findings() const;
  const diag::Findings& raw_findings() const { return findings_; }

 private:
  diag::Sources sources_;
  diag::Findings findings_;
  std::unique_ptr<spec::ObjectSpec> spec_;
  std::optional<model::Object> object_;
};

/// Returns the line of the only finding, or all lines if there are several findings.
std::string OnlyFinding(const std::string& body);

/// A folder that is removed by the destructor.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }
  void Write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

}  // namespace mjforge::assemble
