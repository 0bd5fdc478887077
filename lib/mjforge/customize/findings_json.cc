// Writer of findings as JSON for the page of `mjforge customize`: sorted, each once, limited.

#include "mjforge/customize/findings_json.h"

namespace mjforge::customize {
namespace {

constexpr std::size_t kMostFindings = 50;

}  // namespace

void WriteFindings(diag::Json& json, diag::Findings findings, const diag::Sources& sources) {
  findings.Sort();
  findings.Unique();
  findings.Truncate(kMostFindings);
  json.Each("findings", findings, [&](const diag::Finding& finding) {
    json.Key("finding");
    json.Raw(diag::RenderJson(finding, sources));
    json.Member("text", diag::SafeText(sources.Line(finding.mark)));
  });
}

}  // namespace mjforge::customize
