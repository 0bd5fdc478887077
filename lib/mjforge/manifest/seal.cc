// Writing, reading and comparing the seals of finished batches.

#include "mjforge/manifest/seal.h"

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/manifest/record_values.h"

namespace mjforge::manifest {
namespace {

using rapidjson::Value;

constexpr int kVersion = 1;

// Key of the last member of a seal, the checksum of the seal's text before this member.
constexpr std::string_view kOwn = R"(,"xxh128":")";

std::string WithChecksum(std::string_view body) {
  return fmt::format("{}{}{}\"}}\n", body, kOwn, bytes::ChecksumOf(body));
}

constexpr JsonMember<Seal> kMembers[] = {
    {"name", &Seal::name},   {"output", &Seal::output}, {"per_archive", &Seal::per_archive},
    {"spec", &Seal::spec},   {"first", &Seal::first},   {"count", &Seal::count},
    {"shard", &Seal::shard}, {"shards", &Seal::shards}, {"records", &Seal::records}};

void PutFile(Json& json, const SealedFile& file) {
  json.Member("file", file.file);
  json.Member("bytes", file.content.size);
  json.Member("xxh128", file.content.checksum);
}

bool GetFile(const Value& value, SealedFile& file) {
  return GetMember(value, "file", file.file) && GetMember(value, "bytes", file.content.size) &&
         GetMember(value, "xxh128", file.content.checksum);
}

bool GetSeal(const Value& object, Seal& seal) {
  Members<std::string> assets;
  if (!GetAll(object, seal, kMembers) || !object.HasMember("manifest") ||
      !GetFile(object["manifest"], seal.manifest) || !object.HasMember("archives") ||
      !object["archives"].IsArray() || !GetMember(object, "assets", assets)) {
    return false;
  }
  seal.assets = {assets.begin(), assets.end()};
  return seal.shards > 0 && seal.shard < seal.shards &&
         std::ranges::all_of(object["archives"].GetArray(), [&](const Value& archive) {
           return GetFile(archive, seal.archives.emplace_back());
         });
}

}  // namespace

std::filesystem::path SealPathOf(const std::filesystem::path& manifest) {
  std::filesystem::path path = manifest;
  if (path.extension() == ".zst") path.replace_extension();
  return path.replace_extension(".seal.json");
}

std::string SealText(const Seal& seal) {
  Json json(expr::AppendExactNumber);
  json.StartObject();
  json.Member("mjforge_seal", kVersion);
  PutAll(json, seal, kMembers);
  json.Object("manifest", [&] { PutFile(json, seal.manifest); });
  json.Each("archives", seal.archives, [&](const SealedFile& file) { PutFile(json, file); });
  json.Object("assets", [&] { json.Members(seal.assets); });
  return WithChecksum(json.Take());
}

std::optional<Seal> ReadSeal(std::string_view text, std::string& why_not) {
  rapidjson::Document document;
  if (!diag::IsNestedTooDeep(text))
    document.Parse<rapidjson::kParseIterativeFlag>(text.data(), text.size());
  std::uint64_t version = 0;
  if (document.HasParseError() || !GetMember(document, "mjforge_seal", version))
    return diag::Refuse(why_not, "it is not a seal");
  if (version != kVersion)
    return diag::Refuse(
        why_not, fmt::format("it has version {}, and this mjforge knows {}", version, kVersion));
  Seal seal;
  // Compares all bytes of the text, because JSON permits other whitespace around the checksum.
  if (GetSeal(document, seal) && text == WithChecksum(text.substr(0, text.rfind(kOwn))))
    return seal;
  return diag::Refuse(why_not, "it is damaged");
}

std::optional<Seal> ReadSealBeside(const std::filesystem::path& manifest, std::string& why_not) {
  const auto text = bytes::Read(SealPathOf(manifest), kMaxSeal, why_not);
  return text ? ReadSeal(*text, why_not) : std::nullopt;
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
