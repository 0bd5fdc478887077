// Reporter of findings that omits findings whose code the spec silences (`silence:`).
#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::static_checks {

/// Adds findings, except those whose code is silenced in the checks of the spec.
class Reporter {
 public:
  Reporter(const model::Checks& checks, diag::Findings& findings)
      : checks_(checks), findings_(findings) {}

  void Error(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});
  void Warning(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});

  bool IsSilenced(diag::Code code) const;

  const model::Checks& checks() const { return checks_; }

 private:
  const model::Checks& checks_;
  diag::Findings& findings_;
};

}  // namespace mjforge::static_checks
