#include "mjforge/physics/verdict.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::physics {

std::string NumberBeyond(double value, double limit) {
  std::string text;
  for (int digits = 3; digits <= 17; ++digits) {
    text = fmt::format("{:.{}g}", value, digits);
    const double shown = expr::ParseNumber(text).value_or(value);
    if (shown != limit && (shown < limit) == (value < limit)) break;
  }
  return text;
}

bool Verdict::IsSilenced(diag::Code code) const {
  const std::string_view name = diag::CodeName(code);
  return std::ranges::any_of(checks_.silenced,
                             [&](const auto& silence) { return silence.first == name; });
}

void Verdict::Error(diag::Code code, diag::SourceMark mark, std::string message, std::string hint) {
  if (!IsSilenced(code)) findings_.Add(code, mark, std::move(message), std::move(hint));
}

void Verdict::Warning(diag::Code code, diag::SourceMark mark, std::string message,
                      std::string hint) {
  if (!IsSilenced(code)) findings_.Warn(code, mark, std::move(message), std::move(hint));
}

}  // namespace mjforge::physics
