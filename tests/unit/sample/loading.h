#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"

using Strings = std::vector<std::string>;

/// A spec loaded from a text, and what is found while it is sampled.
struct Family {
  std::unique_ptr<mjforge::spec::ObjectSpec> spec;
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;

  /// Parameter `name` of a variant; NaN when it cannot be drawn.
  double Number(std::string_view name, mjforge::sample::DrawKey key = {},
                const mjforge::sample::Sampler* sampler = nullptr);
  mjforge::sample::ParameterValue Parameter(std::string_view name,
                                            mjforge::sample::DrawKey key = {},
                                            const mjforge::sample::Sampler* sampler = nullptr);
  /// An evaluator of one variant whose parameters are drawn.
  mjforge::sample::Evaluator Evaluator(mjforge::sample::DrawKey key = {},
                                       const mjforge::sample::Sampler* sampler = nullptr);
  /// The value of a key of the spec's first part.
  const mjforge::spec::Value& PartValue(std::string_view key) const;
  /// Each finding as "line:column code: message (hint) seed/index".
  Strings Report() const;
};

/// The spec `mjforge: 1, name: t` with `params` (a YAML flow mapping), line 3,
/// other keys from line 4 on, and, unless they have parts, one box.
Family Load(const std::string& params, const std::string& more = "");

/// What is found when variant (seed 7, index 3) of these parameters is drawn.
Strings ReportOf(const std::string& params, const std::string& more = "");
