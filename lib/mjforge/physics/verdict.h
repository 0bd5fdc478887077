#pragma once

#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Takes findings, except those whose code is silenced.
class Verdict {
 public:
  Verdict(const model::Checks& checks, diag::Findings& findings)
      : checks_(checks), findings_(findings) {}

  void Error(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});
  void Warning(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});

  bool IsSilenced(diag::Code code) const;

  const model::Checks& checks() const { return checks_; }

 private:
  const model::Checks& checks_;
  diag::Findings& findings_;
};

}  // namespace mjforge::physics
