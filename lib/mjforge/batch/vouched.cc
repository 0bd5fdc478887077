#include "mjforge/batch/vouched.h"

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

// More than a seal with as many archives as there may be files in a folder.
constexpr std::uint64_t kMaxSeal = std::uint64_t{64} << 20;

void AddBroken(const std::filesystem::path& file, const std::string& why_not,
               diag::Findings& findings) {
  std::error_code ignored;
  const bool exists = std::filesystem::exists(file, ignored);
  findings.Add(exists ? diag::Code::kBatchChanged : diag::Code::kBatchMissing, {},
               exists ? fmt::format("'{}' was changed: {}", file.string(), why_not)
                      : fmt::format("'{}' is missing", file.string()),
               "run the command that made it again with --resume");
}

}  // namespace

std::optional<manifest::Seal> ReadSealOf(const std::filesystem::path& manifest,
                                         std::string& why_not) {
  const auto text = bytes::Read(manifest::SealOf(manifest), kMaxSeal, why_not);
  return text ? manifest::ReadSeal(*text, why_not) : std::nullopt;
}

bool IsAsSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                std::string& why_not) {
  return verify ? bytes::IsSound(folder / file.file, file.whole, why_not)
                : bytes::HasSize(folder / file.file, file.whole.size, why_not);
}

bool HasObject(const std::filesystem::path& folder, const manifest::Record& record, bool verify,
               std::string& why_not) {
  const auto text = bytes::ReadStart(folder / record.file, verify ? bytes::kMaxMjcf : 1, why_not);
  if (!text) return false;
  if (verify ? bytes::Sha256Of(*text) == record.sha256 : !text->empty()) return true;
  why_not = text->empty() ? "it is empty" : "its bytes are others";
  return false;
}

bool CheckSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 diag::Findings& findings) {
  std::string why_not;
  if (IsAsSealed(folder, file, verify, why_not)) return true;
  AddBroken(folder / file.file, why_not, findings);
  return false;
}

bool CheckObject(const std::filesystem::path& folder, const manifest::Record& record, bool verify,
                 diag::Findings& findings) {
  std::string why_not;
  if (HasObject(folder, record, verify, why_not)) return true;
  AddBroken(folder / record.file, why_not, findings);
  return false;
}

}  // namespace mjforge::batch
