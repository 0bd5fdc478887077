#include <fmt/format.h>

#include <algorithm>

#include "mjforge/batch/sink.h"

namespace mjforge::batch {

bool FailedByChance(const manifest::Record& record) {
  const std::string died =
      fmt::format("\"code\":\"{}\"", diag::CodeName(diag::Code::kBatchWorkerDied));
  return std::any_of(
      record.findings.begin(), record.findings.end(),
      [&](const std::string& finding) { return finding.find(died) != finding.npos; });
}

void AddDiffers(const std::filesystem::path& file, const std::string& difference,
                diag::Findings& findings) {
  findings.Add(diag::Code::kBatchDiffers, {},
               fmt::format("'{}' belongs to another batch: {}", file.string(), difference),
               "use the options of that batch, or start over without --resume");
}

std::optional<Kept> ReadKept(const std::filesystem::path& manifest, const SinkOptions& options,
                             const std::function<bool(const manifest::Record&)>& is_good,
                             diag::Findings& findings, std::uint64_t bytes) {
  Kept kept;
  std::string why_not;
  std::optional<bytes::LineReader> lines = bytes::LineReader::Open(manifest, why_not);
  std::string line;
  while (lines && kept.done() < options.range.count && lines->Next(line, why_not)) {
    if (lines->torn() || kept.bytes + line.size() + 1 > bytes) break;
    const std::optional<manifest::Record> record = manifest::ReadRecord(line, why_not);
    if (!record) break;  // a crash of the machine may leave anything
    std::string difference = manifest::DifferenceOfBatch(*record, options.batch);
    const std::uint64_t expected = options.range.first + kept.done();
    if (difference.empty() && record->index != expected)
      difference = fmt::format("index is {}, not {}", record->index, expected);
    if (!difference.empty()) {
      AddDiffers(manifest, difference, findings);
      return std::nullopt;
    }
    if (FailedByChance(*record) || !is_good(*record)) break;
    kept.Add(record->status);
    kept.bytes += line.size() + 1;
  }
  return kept;
}

}  // namespace mjforge::batch
