// Reads thresholds of checks (settings `checks.NAME`) for files that have no spec.

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

std::optional<model::Checks> LoadChecks(const std::vector<spec::Setting>& settings,
                                        diag::Sources& sources, diag::Findings& findings) {
  // Minimal spec, so that the thresholds are read by the same code as the settings of any other
  // spec.
  constexpr const char* kSpec =
      "mjforge: 1\n"
      "name: checks\n"
      "parts: [{name: part, type: sphere, size: 1}]\n";
  for (const spec::Setting& setting : settings) {
    if (setting.name.starts_with("checks.")) continue;
    findings.Add(diag::Code::kSpecUnknownParameter, {},
                 "'" + setting.name + "' is not a threshold of a check",
                 "a file has no parameters to set, only thresholds: checks.NAME");
  }
  if (findings.HasErrors()) return std::nullopt;
  const auto spec =
      spec::LoadSpecText("checks", kSpec, ".", {.settings = settings}, sources, findings);
  if (spec == nullptr) return std::nullopt;
  auto values = sample::Sample(*spec, {}, sample::kRootStream, {}, findings);
  if (!values) return std::nullopt;
  const auto object = assemble::Assembler().Assemble(*values, {}, findings);
  return object ? std::optional(object->checks) : std::nullopt;
}

}  // namespace mjforge::forge
