// Writing, reading and comparing records by the table of fields, and the JSON Schema of that table.

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/exact_json.h"
#include "mjforge/manifest/record_fields.h"

namespace mjforge::manifest {

void AppendRecord(std::string& out, const Record& record) {
  diag::Json json(expr::AppendExactNumber, std::move(out));
  json.StartObject();
  for (const RecordField& field : RecordFields()) {
    if (field.is_absent != nullptr && field.is_absent(record)) continue;
    json.Key(field.key);
    field.write(json, record);
  }
  json.EndObject();
  out = json.Take();
  out += '\n';
}

void AppendWithPlaces(std::string& out, std::string_view line, const std::string& archive,
                      const std::string& spec_file) {
  // Quotes within values are escaped, so `next` is found only where it is a key.
  const auto insert = [&](std::string_view key, const std::string& value, std::string_view next) {
    const std::size_t at = line.find(next);
    out += line.substr(0, at);
    line.remove_prefix(at);
    if (value.empty()) return;
    out += key;
    diag::Json json(expr::AppendExactNumber, std::move(out) + ':');
    json.Value(value);
    out = json.Take();
  };
  insert(R"(,"archive")", archive, R"(,"name":)");
  insert(R"(,"spec_file")", spec_file, R"(,"spec_sha256":)");
  out += line;
}

std::optional<Record> ReadRecord(std::string_view line, std::string& why_not) {
  if (diag::IsNestedTooDeep(line)) {
    why_not = fmt::format("values are nested more than {} deep", diag::kMaxJsonDepth);
    return std::nullopt;
  }
  rapidjson::Document document;
  if (!ParseExactly(line, document) || !document.IsObject()) {
    why_not = "it is not a JSON object";
    return std::nullopt;
  }
  Record record;
  for (const RecordField& field : RecordFields()) {
    const auto member = document.FindMember(field.key);
    if (member != document.MemberEnd()) {
      const std::string_view kind = field.read(member->value, record);
      if (kind.empty()) continue;
      why_not = fmt::format("'{}' is not {}", field.key, kind);
      return std::nullopt;
    }
    if (field.is_absent != nullptr) continue;
    why_not = fmt::format("it has no '{}'", field.key);
    return std::nullopt;
  }
  return record;
}

std::string DifferenceOfBatch(const Record& record, const Record& other) {
  for (const RecordField& field : RecordFields()) {
    if (field.same == nullptr || field.same(record, other)) continue;
    const auto text = [&](const Record& of) {
      diag::Json json(expr::AppendExactNumber);
      field.write(json, of);
      std::string value = json.Take();
      return value.starts_with('"') ? value.substr(1, value.size() - 2) : value;
    };
    return fmt::format("{} is '{}', not '{}'", field.key, text(record), text(other));
  }
  return {};
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
      "  \"description\": \"One line of manifest.jsonl: one variant. Lines are in index order.\",\n"
      "  \"type\": \"object\",\n"
      "  \"additionalProperties\": false,\n"
      "  \"required\": [{}],\n"
      "  \"properties\": {{\n{}\n  }}\n"
      "}}\n",
      required, properties);
}

}  // namespace mjforge::manifest
