#include "loading.h"

#include <fmt/format.h>

std::vector<std::string> Loaded::Report() const {
  std::vector<std::string> lines;
  for (const mjforge::diag::Finding& finding : findings) {
    if (finding.code == mjforge::diag::Code::kSpecUnused) continue;
    lines.push_back(fmt::format("{}:{} {}: {}{}", finding.mark.line, finding.mark.column,
                                mjforge::diag::CodeName(finding.code), finding.message,
                                finding.hint.empty() ? "" : " (" + finding.hint + ")"));
  }
  return lines;
}

std::vector<std::string> Loaded::Unused() const {
  std::vector<std::string> lines;
  for (const mjforge::diag::Finding& finding : findings) {
    if (finding.code != mjforge::diag::Code::kSpecUnused) continue;
    lines.push_back(
        fmt::format("{}:{} {}", finding.mark.line, finding.mark.column, finding.message));
  }
  return lines;
}

Loaded Load(const std::string& yaml, std::vector<mjforge::spec::Setting> settings) {
  Loaded loaded;
  mjforge::spec::LoadOptions options;
  options.settings = std::move(settings);
  loaded.spec =
      mjforge::spec::LoadSpecText("test.yaml", yaml, ".", options, loaded.sources, loaded.findings);
  return loaded;
}

Loaded LoadWithBox(const std::string& text) {
  return Load("mjforge: 1\nname: t\nparts: [{name: a, type: box, size: [1, 1, 1]}]\n" + text);
}

std::vector<std::string> ReportWithBox(const std::string& text) {
  return LoadWithBox(text).Report();
}
