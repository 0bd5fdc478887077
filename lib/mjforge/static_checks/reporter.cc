// Reporter of findings that omits silenced codes, and names without the object's prefix.
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

std::string_view OwnName(std::string_view name, std::string_view object) {
  const bool has_prefix = name.starts_with(object) && name.substr(object.size()).starts_with('_');
  return has_prefix ? name.substr(object.size() + 1) : name;
}

}  // namespace mjforge::static_checks
