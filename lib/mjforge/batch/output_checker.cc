// Comparison of files with the seal and the records of their batch.

#include "mjforge/batch/output_checker.h"

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

// Maximum number of assets whose check results are kept in memory.
constexpr std::size_t kMaxRememberedAssets = 10'000;

void ReportDamage(const std::filesystem::path& file, const std::string& why_not,
                  diag::Findings& findings, std::string_view option = "--resume") {
  const bool exists = bytes::Exists(file);
  findings.Add(exists ? diag::Code::kBatchChanged : diag::Code::kBatchMissing, {},
               exists ? fmt::format("'{}' was changed: {}", file.string(), why_not)
                      : fmt::format("'{}' is missing", file.string()),
               fmt::format("run the command that made it again with {}", option));
}

// Returns true if a file exists and is not empty or, with `verify`, has its hash; otherwise adds a
// finding.
bool CheckHash(const std::filesystem::path& file, bool verify, std::uint64_t limit,
               const std::string& sha256, diag::Findings& findings) {
  std::string why_not;
  const auto start = bytes::ReadStart(file, verify ? limit : 1, why_not);
  if (start && (verify ? bytes::Sha256Of(*start) == sha256 : !start->empty())) return true;
  std::string ignored;
  if (!start && bytes::MayRead(file, limit, ignored)) {
    findings.AddCannotRead(file.string(), why_not);
    return false;
  }
  if (start) why_not = start->empty() ? "it is empty" : "its bytes are others";
  ReportDamage(file, why_not, findings);
  return false;
}

}  // namespace

void ReportMissingShard(const output::Shard& shard, const std::filesystem::path& manifest,
                        diag::Findings& findings) {
  findings.Add(diag::Code::kBatchMissing, {},
               fmt::format("shard {}/{} is missing: there is no '{}'", shard.index, shard.count,
                           manifest.string()),
               fmt::format("make it with --shard {}/{} --resume", shard.index, shard.count));
}

std::string DifferenceOfShards(const manifest::Seal& seal, const manifest::Seal& other) {
  std::string difference = manifest::DifferenceOfOutput(seal, other);
  if (difference.empty() && seal.count != other.count)
    difference = fmt::format("count is '{}', not '{}'", seal.count, other.count);
  return difference;
}

void ReportOtherShard(std::string_view what, const std::string& difference,
                      diag::Findings& findings) {
  findings.Add(diag::Code::kBatchDiffers, {},
               fmt::format("{} belongs to another batch: {}", what, difference),
               "make all shards with the same spec and options");
}

std::vector<std::string> NamesIn(const std::filesystem::path& folder, diag::Findings& findings) {
  std::vector<std::string> names;
  std::error_code error;
  for (const std::filesystem::path& entry : output::EntriesOf(folder, error))
    names.push_back(entry.filename().string());
  if (error) findings.AddCannotRead(folder.string(), error.message());
  std::ranges::sort(names);
  return names;
}

bool CheckSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 diag::Findings& findings) {
  const std::filesystem::path path = folder / file.file;
  std::string why_not;
  const auto found = verify ? bytes::Compare(path, file.content, why_not)
                     : bytes::HasSize(path, file.content.size, why_not)
                         ? bytes::Soundness::kSound
                         : bytes::Soundness::kChanged;
  if (found == bytes::Soundness::kSound) return true;
  if (found == bytes::Soundness::kUnreadable) {
    findings.AddCannotRead(path.string(), why_not);
    return false;
  }
  // Suggests --verify if the size is right, because resuming otherwise compares only sizes.
  std::string ignored;
  const bool has_size = bytes::HasSize(path, file.content.size, ignored);
  ReportDamage(path, why_not, findings, has_size ? "--resume --verify" : "--resume");
  return false;
}

bool OutputChecker::Check(const manifest::Record& record, diag::Findings& findings) {
  return CheckHash(folder_ / record.file, verify_, bytes::kMaxMjcf, record.sha256, findings) &&
         CheckAssets(record, findings);
}

bool OutputChecker::CheckAssets(const manifest::Record& record, diag::Findings& findings) {
  const std::filesystem::path folder = (folder_ / record.file).parent_path();
  // Limits the memory for check results, because each record may have generated assets of its own.
  if (assets_.size() > kMaxRememberedAssets) assets_.clear();
  return std::ranges::all_of(record.assets, [&](const auto& asset) {
    const auto& [name, sha256] = asset;
    const auto [known, is_new] = assets_.try_emplace({folder / name, sha256});
    if (is_new)
      known->second = CheckHash(folder / name, verify_, bytes::kMaxAsset, sha256, findings);
    return known->second;
  });
}

}  // namespace mjforge::batch
