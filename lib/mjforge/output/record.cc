#include <fmt/format.h>
#include <rapidjson/document.h>

#include "mjforge/output/output.h"
#include "mjforge/output/record_fields.h"

namespace mjforge::output {
namespace {

// Takes fields out of a parsed line; the first one that is missing or of the
// wrong kind is the reason why the line is not a record.
class LineReader {
 public:
  LineReader(const rapidjson::Document& line, std::string& why_not)
      : line_(line), why_not_(why_not) {}

  std::string Text(const char* key) {
    const rapidjson::Value* value = Find(key);
    if (value != nullptr && value->IsString())
      return {value->GetString(), value->GetStringLength()};
    Miss(fmt::format("'{}' is not a text", key));
    return {};
  }
  std::string TextOrNull(const char* key) {
    const rapidjson::Value* value = Find(key);
    return value != nullptr && value->IsNull() ? std::string() : Text(key);
  }
  std::uint64_t Whole(const char* key) {
    const rapidjson::Value* value = Find(key);
    if (value != nullptr && value->IsUint64()) return value->GetUint64();
    Miss(fmt::format("'{}' is not a whole number", key));
    return 0;
  }
  std::string TextIfAny(const char* key) { return line_.HasMember(key) ? Text(key) : ""; }
  std::uint64_t WholeIfAny(const char* key) { return line_.HasMember(key) ? Whole(key) : 0; }
  std::vector<std::pair<std::string, std::string>> Settings() {
    std::vector<std::pair<std::string, std::string>> settings;
    const auto set = line_.FindMember("set");
    if (set == line_.MemberEnd()) return settings;
    if (!set->value.IsObject()) {
      Miss("'set' is not an object");
      return settings;
    }
    for (const auto& [name, text] : set->value.GetObject()) {
      if (text.IsString()) settings.emplace_back(name.GetString(), text.GetString());
    }
    return settings;
  }
  bool ok() const { return ok_; }

 private:
  const rapidjson::Value* Find(const char* key) {
    const auto member = line_.FindMember(key);
    if (member != line_.MemberEnd()) return &member->value;
    Miss(fmt::format("it has no '{}'", key));
    return nullptr;
  }
  void Miss(std::string why_not) {
    if (ok_) why_not_ = std::move(why_not);
    ok_ = false;
  }

  const rapidjson::Document& line_;
  std::string& why_not_;
  bool ok_ = true;
};

}  // namespace

void AppendRecord(std::string& out, const Record& record) {
  rapidjson::StringBuffer buffer;
  JsonWriter json(buffer);
  json.StartObject();
  for (const RecordField& field : RecordFields()) {
    if (field.is_absent != nullptr && field.is_absent(record)) continue;
    json.Key(field.key.data(), static_cast<rapidjson::SizeType>(field.key.size()));
    field.write(json, record);
  }
  json.EndObject();
  out.append(buffer.GetString(), buffer.GetSize());
  out += '\n';
}

std::optional<Record> ReadRecord(std::string_view line, std::string& why_not) {
  rapidjson::Document document;
  document.Parse<rapidjson::kParseIterativeFlag>(line.data(), line.size());
  if (document.HasParseError() || !document.IsObject()) {
    why_not = "it is not a JSON object";
    return std::nullopt;
  }
  LineReader reader(document, why_not);
  Record record;
  record.file = reader.TextOrNull("file");
  record.name = reader.Text("name");
  record.index = reader.Whole("index");
  record.seed = reader.Whole("seed");
  record.attempt = reader.Whole("attempt");
  record.spec = reader.Text("spec");
  record.spec_sha256 = reader.Text("spec_sha256");
  record.settings = reader.Settings();
  record.target = reader.Text("target");
  record.sampler = reader.TextIfAny("sampler");
  record.batch = reader.WholeIfAny("batch");
  record.status = reader.Text("status");
  record.sha256 = reader.TextOrNull("sha256");
  if (!reader.ok()) return std::nullopt;
  return record;
}

std::string ManifestSchema() {
  std::string required;
  std::string properties;
  for (const RecordField& field : RecordFields()) {
    if (field.is_absent == nullptr)
      required += fmt::format("{}\"{}\"", required.empty() ? "" : ", ", field.key);
    properties += fmt::format("{}    \"{}\": {{\n      \"description\": \"{}\",\n      {}\n    }}",
                              properties.empty() ? "" : ",\n", field.key, field.doc, field.schema);
  }
  return fmt::format(
      "{{\n"
      "  \"$schema\": \"http://json-schema.org/draft-07/schema#\",\n"
      "  \"title\": \"mjforge manifest record\",\n"
      "  \"description\": \"One line of manifest.jsonl: one variant, in index order.\",\n"
      "  \"type\": \"object\",\n"
      "  \"additionalProperties\": false,\n"
      "  \"required\": [{}],\n"
      "  \"properties\": {{\n{}\n  }}\n"
      "}}\n",
      required, properties);
}

}  // namespace mjforge::output
