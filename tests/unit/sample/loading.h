// Specs loaded from text, with their parameters' values and findings.

#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

using Strings = std::vector<std::string>;

/// A spec loaded from a text, and the findings of loading and sampling it.
struct Family {
  std::unique_ptr<mjforge::spec::ObjectSpec> spec;
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;

  /// Returns parameter `name` of a variant, or NaN if it cannot be drawn.
  double Number(std::string_view name, mjforge::sample::DrawKey key = {},
                const mjforge::sample::Sampler* sampler = nullptr);
  mjforge::sample::ParameterValue Parameter(std::string_view name,
                                            mjforge::sample::DrawKey key = {},
                                            const mjforge::sample::Sampler* sampler = nullptr);
  /// Returns an evaluator of one variant whose parameters are drawn.
  mjforge::sample::Evaluator Evaluator(mjforge::sample::DrawKey key = {},
                                       const mjforge::sample::Sampler* sampler = nullptr);
  /// Returns the value of a key of the spec's first part.
  const mjforge::spec::Value& PartValue(std::string_view key) const;
  /// Returns each finding as "line:column code: message (hint) seed/index".
  Strings Report() const;
};

/// Loads the spec `mjforge: 1, name: t` with `params` (a YAML flow mapping) in line 3 and other
/// keys from line 4 on. If there is no key `parts`, adds one box.
Family Load(const std::string& params, const std::string& more = "");

/// Returns the findings of drawing variant (seed 7, index 3) of these parameters.
Strings ReportOf(const std::string& params, const std::string& more = "");
