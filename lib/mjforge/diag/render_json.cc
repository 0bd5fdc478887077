// Rendering of findings as JSON.

#include "mjforge/diag/diag.h"
#include "mjforge/diag/utf8.h"

namespace mjforge::diag {
namespace {

void Text(Json& json, std::string_view key, std::string_view text) {
  json.Member(key, ValidUtf8(text));
}

void Place(Json& json, SourceMark mark, const Sources& sources) {
  if (mark.file == 0 || mark.file > sources.size()) return;
  Text(json, "file", sources.Name(mark.file));
  if (mark.line == 0) return;
  json.Member("line", mark.line);
  if (mark.column > 0) json.Member("column", mark.column);
}

}  // namespace

// Omits members without a value (file, line, column, hint, seed, index); `notes` may be an empty
// list.
std::string RenderJson(const Finding& finding, const Sources& sources) {
  // No number format is needed, because all numbers are integers.
  return JsonObject(nullptr, [&](Json& json) {
    json.Member("severity", finding.severity == Severity::kError ? "error" : "warning");
    json.Member("code", CodeName(finding.code));
    Place(json, finding.mark, sources);
    Text(json, "message", finding.message);
    if (!finding.hint.empty()) Text(json, "hint", finding.hint);
    if (finding.seed) json.Member("seed", *finding.seed);
    if (finding.index) json.Member("index", *finding.index);
    json.Each("notes", finding.notes, [&](const Note& note) {
      Place(json, note.mark, sources);
      Text(json, "message", note.message);
    });
  });
}

}  // namespace mjforge::diag
