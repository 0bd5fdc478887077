// Writing, reading and comparing records by the table RecordFields(), and its JSON Schema.

#include <fmt/format.h>

#include <array>
#include <cstddef>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/exact_json.h"
#include "mjforge/manifest/record_fields.h"

namespace mjforge::manifest {
namespace {

// Returns the value of each field, in the order of RecordFields(); null if the JSON object lacks
// the field. The search for a key begins after the field of the previous key, because members
// usually have the order of RecordFields().
std::vector<const rapidjson::Value*> ValuesOf(const rapidjson::Document& object) {
  const std::span<const RecordField> fields = RecordFields();
  std::vector<const rapidjson::Value*> values(fields.size());
  std::size_t next = 0;
  for (const auto& [name, value] : object.GetObject()) {
    const std::string_view key(name.GetString(), name.GetStringLength());
    std::size_t tries = 0;
    while (tries < fields.size() && fields[next % fields.size()].key != key) ++next, ++tries;
    const rapidjson::Value*& known = values[next % fields.size()];
    if (tries < fields.size() && known == nullptr) known = &value;
    ++next;
  }
  return values;
}

}  // namespace

void AppendRecord(std::string& out, const Record& record) {
  diag::Json json(expr::AppendExactNumber, std::move(out));
  json.Object([&] {
    for (const RecordField& field : RecordFields()) {
      if (field.is_absent != nullptr && field.is_absent(record)) continue;
      json.Key(field.key);
      field.write(json, record);
    }
  });
  out = json.Take();
  out += '\n';
}

void AppendWithPaths(std::string& out, std::string_view line, const std::string& archive,
                     const std::string& spec_file) {
  // Quotes within texts are escaped, so `next` is found only where it is a key.
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
  alignas(std::max_align_t) std::array<char, kParserBytes> memory;
  rapidjson::MemoryPoolAllocator<> allocator(memory.data(), memory.size());
  std::string text(line);  // declared before the document, whose texts are parts of it
  rapidjson::Document document(&allocator);
  if (!ParseExactly(text, document) || !document.IsObject())
    return diag::Refuse(
        why_not, diag::IsNestedTooDeep(line)
                     ? fmt::format("values are nested more than {} deep", diag::kMaxJsonDepth)
                     : "it is not a JSON object");
  const std::vector<const rapidjson::Value*> values = ValuesOf(document);
  Record record;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const RecordField& field = RecordFields()[i];
    if (values[i] != nullptr) {
      const std::string_view kind = field.read(*values[i], record);
      if (kind.empty()) continue;
      return diag::Refuse(why_not, fmt::format("'{}' is not {}", field.key, kind));
    }
    if (field.is_absent != nullptr) continue;
    return diag::Refuse(why_not, fmt::format("it has no '{}'", field.key));
  }
  return record;
}

std::string DifferenceOfBatch(const Record& record, const Record& other) {
  for (const RecordField& field : RecordFields()) {
    if (field.same == nullptr || field.same(record, other)) continue;
    const auto text = [&](const Record& of) -> std::string {
      if (field.is_absent != nullptr && field.is_absent(of)) return "unset";
      diag::Json json(expr::AppendExactNumber);
      field.write(json, of);
      const std::string value = json.Take();
      return fmt::format("'{}'",
                         value.starts_with('"') ? value.substr(1, value.size() - 2) : value);
    };
    return fmt::format("{} is {}, not {}", field.key, text(record), text(other));
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
