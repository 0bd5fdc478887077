#ifndef MJFORGE_TESTS_UNIT_SPEC_LOADING_H_
#define MJFORGE_TESTS_UNIT_SPEC_LOADING_H_

#include <memory>
#include <string>
#include <vector>

#include "mjforge/spec/spec.h"

/// A spec loaded from a text, with what was found in it.
struct Loaded {
  std::unique_ptr<mjforge::spec::ObjectSpec> spec;
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;

  /// Each finding as "line:column code: message (hint)".
  std::vector<std::string> Report() const;
};

Loaded Load(const std::string& yaml, std::vector<mjforge::spec::Setting> settings = {});

/// The spec `mjforge: 1, name: t, <text>` with one box, whose text starts at line 4.
Loaded LoadWithBox(const std::string& text);

/// Report of LoadWithBox.
std::vector<std::string> ReportWithBox(const std::string& text);

using Strings = std::vector<std::string>;

#endif  // MJFORGE_TESTS_UNIT_SPEC_LOADING_H_
