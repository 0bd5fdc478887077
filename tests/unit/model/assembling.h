#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::model {

/// A YAML text on its way to an object. The header (`mjforge: 1`, `name: thing`)
/// is put before `body`, so that the body's first line is line 3.
class Assembling {
 public:
  explicit Assembling(const std::string& body, std::uint64_t seed = 1, std::uint64_t index = 0,
                      const std::filesystem::path& folder = {},
                      const Assembler::NameOptions& options = {});

  /// The object; the test fails, with the findings, if there is none.
  const Object& object() const;
  const Body& body() const { return object().bodies.front(); }
  const Part& part(const std::string& name) const;
  bool failed() const { return !object_; }
  /// Each as "line:column message", with " (hint)" where there is one.
  std::vector<std::string> findings() const;
  const diag::Findings& raw_findings() const { return findings_; }

 private:
  diag::Sources sources_;
  diag::Findings findings_;
  std::unique_ptr<spec::ObjectSpec> spec_;
  std::optional<Object> object_;
};

/// The one finding's line, or all of them when there is not exactly one.
std::string OnlyFinding(const std::string& body);

/// A folder that is removed again.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }
  void Write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

const Attribute* Find(const std::vector<Attribute>& attributes, std::string_view name);

}  // namespace mjforge::model
