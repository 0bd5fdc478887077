// Implementation of the reporter of findings that are not silenced.
#include "mjforge/static_checks/reporter.h"

#include <algorithm>
#include <utility>

namespace mjforge::static_checks {

bool Reporter::IsSilenced(diag::Code code) const {
  const std::string_view name = diag::CodeName(code);
  return std::ranges::any_of(checks_.silenced,
                             [&](const auto& silence) { return silence.first == name; });
}

void Reporter::Error(diag::Code code, diag::SourceMark mark, std::string message,
                     std::string hint) {
  if (!IsSilenced(code)) findings_.Add(code, mark, std::move(message), std::move(hint));
}

void Reporter::Warning(diag::Code code, diag::SourceMark mark, std::string message,
                       std::string hint) {
  if (!IsSilenced(code)) findings_.Warn(code, mark, std::move(message), std::move(hint));
}

}  // namespace mjforge::static_checks
