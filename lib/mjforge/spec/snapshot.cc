// Text form of snapshots of specs: writing and reading.

#include "mjforge/spec/snapshot.h"

#include <rapidjson/document.h>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"

namespace mjforge::spec {
namespace {

namespace fs = std::filesystem;
using Texts = Snapshot::Texts;

constexpr std::string_view kStart = R"({"mjforge_snapshot":1,)";
static_assert(kStart.size() == kSnapshotHead);
// Maximum size of a snapshot in bytes, enough for several specs of the largest size.
constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

bool IsTexts(const rapidjson::Value& list) {
  if (!list.IsArray()) return false;
  for (const rapidjson::Value& item : list.GetArray()) {
    if (!item.IsString()) return false;
  }
  return true;
}

std::string TextOf(const rapidjson::Value& value) {
  return {value.GetString(), value.GetStringLength()};
}

// Adds the texts of a JSON list of [path, text] to `texts`. Returns false for a list of another
// form.
bool ReadTexts(const rapidjson::Value& list, Texts& texts) {
  for (const rapidjson::Value& file : list.GetArray()) {
    if (!IsTexts(file) || file.Size() != 2) return false;
    texts[TextOf(file[0])] = TextOf(file[1]);
  }
  return true;
}

void WriteTexts(diag::Json& json, std::string_view key, const Texts& texts) {
  json.List(key, texts, [&](const auto& file) {
    json.Value(std::vector<std::string>{file.first.string(), file.second});
  });
}

// Reads the members of the JSON object into the snapshot. Returns false if a member is missing or
// has another type.
bool ReadMembers(const rapidjson::Document& json, Snapshot& snapshot) {
  for (const char* name : {"spec", "text_name", "folder"}) {
    if (!json.HasMember(name) || !json[name].IsString()) return false;
  }
  for (const char* name : {"search_path", "found", "texts", "parameter_texts"}) {
    if (!json.HasMember(name) || !json[name].IsArray()) return false;
  }
  snapshot.spec = TextOf(json["spec"]);
  snapshot.text_name = TextOf(json["text_name"]);
  snapshot.folder = TextOf(json["folder"]);
  if (!IsTexts(json["search_path"])) return false;
  for (const rapidjson::Value& folder : json["search_path"].GetArray())
    snapshot.search_path.emplace_back(TextOf(folder));
  for (const rapidjson::Value& found : json["found"].GetArray()) {
    if (!IsTexts(found) || found.Size() != 3) return false;
    snapshot.found[{TextOf(found[0]), TextOf(found[1])}] = TextOf(found[2]);
  }
  return ReadTexts(json["texts"], snapshot.texts) &&
         ReadTexts(json["parameter_texts"], snapshot.parameter_texts);
}

fs::path CurrentFolder() {
  std::error_code error;
  return fs::current_path(error);
}

}  // namespace

std::string SnapshotText(const Snapshot& snapshot) {
  const fs::path folder = snapshot.folder.empty() ? CurrentFolder() : snapshot.folder;
  diag::Json json(nullptr, std::string(kStart.substr(0, kStart.size() - 1)));
  json.Member("spec", snapshot.spec);
  json.Member("text_name", snapshot.text_name);
  json.Member("folder", folder.string());
  json.List("search_path", snapshot.search_path,
            [&](const fs::path& searched) { json.Value((folder / searched).string()); });
  json.List("found", snapshot.found, [&](const auto& found) {
    const auto& [key, file] = found;
    json.Value(std::vector<std::string>{key.first.string(), key.second, file.string()});
  });
  WriteTexts(json, "texts", snapshot.texts);
  WriteTexts(json, "parameter_texts", snapshot.parameter_texts);
  json.EndObject();
  return json.Take() + '\n';
}

bool IsSnapshot(std::string_view start) { return start.starts_with(kStart); }

std::optional<Snapshot> ReadSnapshot(std::string text) {
  rapidjson::Document json;
  Snapshot snapshot;
  if (!IsSnapshot(text) || diag::IsNestedTooDeep(text)) return std::nullopt;
  if (json.ParseInsitu(text.data()).HasParseError() || !json.IsObject()) return std::nullopt;
  if (!ReadMembers(json, snapshot)) return std::nullopt;
  return snapshot;
}

std::optional<Snapshot> OpenSnapshot(const std::string& reference, diag::Findings& findings) {
  if (reference != bytes::kStandardInput && !reference.ends_with(".json")) return std::nullopt;
  std::string why_not;
  const auto start = bytes::ReadStart(reference, kSnapshotHead, why_not);
  if (!start || !IsSnapshot(*start)) return std::nullopt;
  std::optional<std::string> text = bytes::Read(reference, kMaxBytes, why_not);
  std::optional<Snapshot> snapshot = text ? ReadSnapshot(*std::move(text)) : std::nullopt;
  if (!snapshot) {
    findings.Add(diag::Code::kYamlCannotRead, {},
                 fmt::format("'{}' is a damaged snapshot of a spec", reference));
  } else if (reference != bytes::kStandardInput) {
    snapshot->parameter_texts.clear();
  }
  return snapshot;
}

}  // namespace mjforge::spec
