#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mjforge/spec/spec.h"

/// A spec loaded from a text, with what was found in it.
struct Loaded {
  std::unique_ptr<mjforge::spec::ObjectSpec> spec;
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;

  /// Each finding as "line:column code: message (hint)", except what is never used: most tests use
  /// little of what they declare.
  std::vector<std::string> Report() const;
  /// What is never used, as "line:column message".
  std::vector<std::string> Unused() const;
};

Loaded Load(const std::string& yaml, std::vector<mjforge::spec::Setting> settings = {});

/// The spec `mjforge: 1, name: t, <text>` with one box, whose text starts at line 4.
Loaded LoadWithBox(const std::string& text);

/// Report of LoadWithBox.
std::vector<std::string> ReportWithBox(const std::string& text);

using Strings = std::vector<std::string>;
