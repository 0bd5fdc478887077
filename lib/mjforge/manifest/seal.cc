#include "mjforge/manifest/seal.h"

#include <fmt/format.h>
#include <rapidjson/document.h>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"

namespace mjforge::manifest {
namespace {

using diag::Json;
using rapidjson::Value;

constexpr int kVersion = 1;

// The last member is the checksum of the text before it.
constexpr std::string_view kOwn = R"(,"xxh128":")";

void Put(Json& json, const SealedFile& file) {
  json.StartObject();
  json.Member("file", file.file);
  json.Member("bytes", file.whole.size);
  json.Member("xxh128", file.whole.checksum);
  json.EndObject();
}

bool Get(const Value& object, const char* key, std::uint64_t& number) {
  const auto member = object.FindMember(key);
  if (member == object.MemberEnd() || !member->value.IsUint64()) return false;
  number = member->value.GetUint64();
  return true;
}

bool Get(const Value& object, const char* key, std::string& text) {
  const auto member = object.FindMember(key);
  if (member == object.MemberEnd() || !member->value.IsString()) return false;
  text.assign(member->value.GetString(), member->value.GetStringLength());
  return true;
}

bool Get(const Value& value, SealedFile& file) {
  return value.IsObject() && Get(value, "file", file.file) &&
         Get(value, "bytes", file.whole.size) && Get(value, "xxh128", file.whole.checksum);
}

bool Get(const Value& object, std::map<std::string, std::string>& texts) {
  for (const auto& [name, text] : object.GetObject()) {
    if (!text.IsString()) return false;
    texts.emplace(name.GetString(), text.GetString());
  }
  return true;
}

bool Get(const Value& object, Seal& seal) {
  const auto manifest = object.FindMember("manifest");
  const auto archives = object.FindMember("archives");
  const auto assets = object.FindMember("assets");
  if (!Get(object, "name", seal.name) || !Get(object, "output", seal.output) ||
      !Get(object, "per_archive", seal.per_archive) || !Get(object, "spec", seal.spec) ||
      !Get(object, "first", seal.first) || !Get(object, "count", seal.count) ||
      !Get(object, "shard", seal.shard) || !Get(object, "shards", seal.shards) ||
      !Get(object, "records", seal.records) || manifest == object.MemberEnd() ||
      !Get(manifest->value, seal.manifest) || archives == object.MemberEnd() ||
      !archives->value.IsArray() || assets == object.MemberEnd() || !assets->value.IsObject() ||
      !Get(assets->value, seal.assets)) {
    return false;
  }
  for (const Value& archive : archives->value.GetArray()) {
    if (!Get(archive, seal.archives.emplace_back())) return false;
  }
  return seal.shards > 0 && seal.shard < seal.shards;
}

}  // namespace

std::filesystem::path SealOf(const std::filesystem::path& manifest) {
  return std::filesystem::path(manifest).replace_extension(".seal.json");
}

std::string SealText(const Seal& seal) {
  Json json(expr::AppendExactNumber);
  json.StartObject();
  json.Member("mjforge_seal", kVersion);
  json.Member("name", seal.name);
  json.Member("output", seal.output);
  json.Member("per_archive", seal.per_archive);
  json.Member("spec", seal.spec);
  json.Member("first", seal.first);
  json.Member("count", seal.count);
  json.Member("shard", seal.shard);
  json.Member("shards", seal.shards);
  json.Member("records", seal.records);
  json.Key("manifest");
  Put(json, seal.manifest);
  json.Key("archives");
  json.StartArray();
  for (const SealedFile& archive : seal.archives) Put(json, archive);
  json.EndArray();
  json.Key("assets");
  json.StartObject();
  for (const auto& [name, sha256] : seal.assets) json.Member(name, sha256);
  json.EndObject();
  std::string text = json.Take();
  text += fmt::format("{}{}\"}}\n", kOwn, bytes::ChecksumOf(text));
  return text;
}

std::optional<Seal> ReadSeal(std::string_view text, std::string& why_not) {
  rapidjson::Document document;
  if (!diag::IsNestedTooDeep(text))
    document.Parse<rapidjson::kParseIterativeFlag>(text.data(), text.size());
  std::uint64_t version = 0;
  if (document.HasParseError() || !document.IsObject() || !Get(document, "mjforge_seal", version)) {
    why_not = "it is not a seal";
    return std::nullopt;
  }
  if (version != kVersion) {
    why_not = fmt::format("it has version {}, and this mjforge knows {}", version, kVersion);
    return std::nullopt;
  }
  Seal seal;
  const std::string_view body = text.substr(0, text.rfind(kOwn));
  std::string checksum;
  if (Get(document, seal) && Get(document, "xxh128", checksum) &&
      checksum == bytes::ChecksumOf(body))
    return seal;
  why_not = "it is damaged";
  return std::nullopt;
}

std::string DifferenceOfOutput(const Seal& seal, const Seal& other) {
  const auto differ = [](std::string_view key, const auto& a, const auto& b) {
    return a == b ? std::string() : fmt::format("{} is '{}', not '{}'", key, a, b);
  };
  std::string difference = differ("output", seal.output, other.output);
  if (difference.empty()) difference = differ("per_archive", seal.per_archive, other.per_archive);
  if (difference.empty()) difference = differ("first", seal.first, other.first);
  if (difference.empty()) difference = differ("name", seal.name, other.name);
  return difference;
}

}  // namespace mjforge::manifest
