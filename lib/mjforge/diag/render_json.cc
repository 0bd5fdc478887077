#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include "mjforge/diag/diag.h"
#include "mjforge/diag/utf8.h"

namespace mjforge::diag {
namespace {

using Writer = rapidjson::Writer<rapidjson::StringBuffer>;

void Text(Writer& writer, const char* key, std::string_view value) {
  const std::string valid = ValidUtf8(value);
  writer.Key(key);
  writer.String(valid.data(), static_cast<rapidjson::SizeType>(valid.size()));
}

void Place(Writer& writer, SourceMark mark, const Sources& sources) {
  if (mark.file == 0 || mark.file > sources.size()) return;
  Text(writer, "file", sources.Name(mark.file));
  if (mark.line == 0) return;
  writer.Key("line");
  writer.Uint(mark.line);
  if (mark.column == 0) return;
  writer.Key("column");
  writer.Uint(mark.column);
}

void Notes(Writer& writer, const std::vector<Note>& notes, const Sources& sources) {
  writer.Key("notes");
  writer.StartArray();
  for (const Note& note : notes) {
    writer.StartObject();
    Place(writer, note.mark, sources);
    Text(writer, "message", note.message);
    writer.EndObject();
  }
  writer.EndArray();
}

}  // namespace

// What a finding does not have (a place, a hint, a variant) is left out; the
// list of notes is always there.
std::string RenderJson(const Finding& finding, const Sources& sources) {
  rapidjson::StringBuffer buffer;
  Writer writer(buffer);
  writer.StartObject();
  Text(writer, "severity", finding.severity == Severity::kError ? "error" : "warning");
  Text(writer, "code", CodeName(finding.code));
  Place(writer, finding.mark, sources);
  Text(writer, "message", finding.message);
  if (!finding.hint.empty()) Text(writer, "hint", finding.hint);
  if (finding.seed) {
    writer.Key("seed");
    writer.Uint64(*finding.seed);
  }
  if (finding.index) {
    writer.Key("index");
    writer.Uint64(*finding.index);
  }
  Notes(writer, finding.notes, sources);
  writer.EndObject();
  return std::string(buffer.GetString(), buffer.GetSize());
}

}  // namespace mjforge::diag
