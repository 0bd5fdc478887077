#include <fmt/format.h>
#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include "mjforge/manifest/manifest.h"
#include "mjforge/manifest/physics_json.h"
#include "mjforge/manifest/record_fields.h"

namespace mjforge::manifest {
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
  // Empty where there is none.
  std::string OptionalText(const char* key) {
    return line_.HasMember(key) ? Text(key) : std::string();
  }
  std::uint64_t OptionalWhole(const char* key) { return line_.HasMember(key) ? Whole(key) : 0; }
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
  std::vector<std::pair<std::string, sample::ParameterValue>> Parameters() {
    std::vector<std::pair<std::string, sample::ParameterValue>> params;
    const rapidjson::Value* members = Find("params");
    if (members == nullptr) return params;
    if (!members->IsObject()) {
      Miss("'params' is not an object");
      return params;
    }
    for (const auto& [name, value] : members->GetObject()) {
      params.emplace_back(name.GetString(), ParameterOf(value));
    }
    return params;
  }
  // Nothing where no object was made.
  std::optional<double> NumberOrNull(const char* key) {
    const rapidjson::Value* value = Find(key);
    if (value != nullptr && value->IsNumber()) return value->GetDouble();
    if (value != nullptr && !value->IsNull()) Miss(fmt::format("'{}' is not a number", key));
    return std::nullopt;
  }
  std::optional<physics::Result> Physics() {
    const auto member = line_.FindMember("physics");
    if (member == line_.MemberEnd()) return std::nullopt;
    std::optional<physics::Result> result = ReadPhysics(member->value);
    if (!result) Miss("'physics' is not what was measured");
    return result;
  }
  // Zeros where no object was made.
  model::Box3 BoxOrNull(const char* key) {
    model::Box3 box;
    const rapidjson::Value* value = Find(key);
    if (value == nullptr || value->IsNull()) return box;
    if (!value->IsObject() || !ReadPoint(*value, "min", box.min) ||
        !ReadPoint(*value, "max", box.max)) {
      Miss(fmt::format("'{}' has no corners", key));
    }
    return box;
  }
  std::vector<std::string> Findings() {
    std::vector<std::string> findings;
    const rapidjson::Value* list = Find("findings");
    if (list == nullptr) return findings;
    if (!list->IsArray()) {
      Miss("'findings' is not a list");
      return findings;
    }
    for (const rapidjson::Value& finding : list->GetArray()) {
      rapidjson::StringBuffer buffer;
      rapidjson::Writer<rapidjson::StringBuffer> json(buffer);
      finding.Accept(json);
      findings.emplace_back(buffer.GetString(), buffer.GetSize());
    }
    return findings;
  }
  bool ok() const { return ok_; }

 private:
  sample::ParameterValue ParameterOf(const rapidjson::Value& value) {
    if (value.IsNumber()) return value.GetDouble();
    if (value.IsBool()) return value.GetBool();
    if (value.IsString()) return std::string(value.GetString(), value.GetStringLength());
    std::vector<double> numbers;
    if (!value.IsArray()) Miss("a parameter is neither a number, a text nor a vector");
    if (!value.IsArray()) return numbers;
    for (const rapidjson::Value& number : value.GetArray()) {
      numbers.push_back(number.IsNumber() ? number.GetDouble() : 0);
    }
    return numbers;
  }
  static bool ReadPoint(const rapidjson::Value& box, const char* key, Eigen::Vector3d& point) {
    const auto member = box.FindMember(key);
    if (member == box.MemberEnd() || !member->value.IsArray() || member->value.Size() != 3)
      return false;
    for (rapidjson::SizeType i = 0; i < 3; ++i) {
      if (!member->value[i].IsNumber()) return false;
      point(i) = member->value[i].GetDouble();
    }
    return true;
  }
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
  JsonText json(out);
  json.StartObject();
  for (const RecordField& field : RecordFields()) {
    if (field.is_absent != nullptr && field.is_absent(record)) continue;
    json.Key(field.key);
    field.write(json, record);
  }
  json.EndObject();
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
  record.spec_file = reader.OptionalText("spec_file");
  record.spec_sha256 = reader.Text("spec_sha256");
  record.archive = reader.OptionalText("archive");
  record.settings = reader.Settings();
  record.sampler = reader.OptionalText("sampler");
  record.batch = reader.OptionalWhole("batch");
  record.params = reader.Parameters();
  const std::optional<double> mass = reader.NumberOrNull("mass");
  record.mass_properties.mass = mass.value_or(0);
  record.nbody = mass ? 1 : 0;
  record.bounds.aabb = reader.BoxOrNull("aabb");
  record.target = reader.Text("target");
  record.validate = reader.Text("validate");
  record.physics = reader.Physics();
  record.on_invalid = reader.OptionalText("on_invalid");
  record.status = reader.Text("status");
  record.findings = reader.Findings();
  record.sha256 = reader.TextOrNull("sha256");
  if (!reader.ok()) return std::nullopt;
  return record;
}

std::string DifferenceOfBatch(const Record& record, const Record& other) {
  const auto differs = [](std::string_view what, const auto& value, const auto& expected) {
    return fmt::format("{} is '{}', not '{}'", what, value, expected);
  };
  if (record.spec != other.spec) return differs("spec", record.spec, other.spec);
  if (record.spec_sha256 != other.spec_sha256)
    return differs("spec_sha256", record.spec_sha256, other.spec_sha256);
  if (record.settings != other.settings) return "the parameters set differ";
  if (record.seed != other.seed) return differs("seed", record.seed, other.seed);
  if (record.sampler != other.sampler) return differs("sampler", record.sampler, other.sampler);
  if (record.batch != other.batch) return differs("batch", record.batch, other.batch);
  if (record.target != other.target) return differs("target", record.target, other.target);
  if (record.validate != other.validate)
    return differs("validate", record.validate, other.validate);
  if (record.on_invalid != other.on_invalid)
    return differs("on_invalid", record.on_invalid, other.on_invalid);
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
      "  \"description\": \"One line of manifest.jsonl: one variant, in index order.\",\n"
      "  \"type\": \"object\",\n"
      "  \"additionalProperties\": false,\n"
      "  \"required\": [{}],\n"
      "  \"properties\": {{\n{}\n  }}\n"
      "}}\n",
      required, properties);
}

}  // namespace mjforge::manifest
