// Reading the records of an unfinished batch that need not be made again.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/batch/sink.h"

namespace mjforge::batch {

bool HasWorkerDied(const manifest::Record& record) {
  const std::string died =
      fmt::format("\"code\":\"{}\"", diag::CodeName(diag::Code::kBatchWorkerDied));
  return std::ranges::any_of(record.findings, [&](const std::string& finding) {
    return finding.find(died) != finding.npos;
  });
}

void ReportOtherBatch(const std::filesystem::path& file, const std::string& difference,
                      diag::Findings& findings) {
  findings.Add(diag::Code::kBatchDiffers, {},
               fmt::format("'{}' belongs to another batch: {}", file.string(), difference),
               "use the options of that batch, or start over without --resume");
}

std::optional<ResumedVariants> ReadResumable(
    const std::filesystem::path& manifest, const SinkOptions& options,
    const std::function<bool(const manifest::Record&)>& is_good, diag::Findings& findings,
    std::uint64_t most) {
  ResumedVariants resumed;
  std::string why_not;
  std::optional<bytes::LineReader> lines = bytes::LineReader::Open(manifest, why_not);
  std::string line;
  most = std::min(most, options.range.count);
  while (lines && resumed.done() < most && lines->Next(line, why_not)) {
    if (lines->is_truncated()) break;
    const std::optional<manifest::Record> record = manifest::ReadRecord(line, why_not);
    if (!record) break;  // a crash of the machine may leave arbitrary bytes
    std::string difference = manifest::DifferenceOfBatch(*record, options.batch);
    const std::uint64_t expected = options.range.first + resumed.done();
    if (difference.empty() && record->index != expected)
      difference = fmt::format("index is {}, not {}", record->index, expected);
    if (!difference.empty()) {
      ReportOtherBatch(manifest, difference, findings);
      return std::nullopt;
    }
    if (HasWorkerDied(*record) || (is_good && !is_good(*record))) break;
    resumed.Add(record->status);
    resumed.bytes += line.size() + 1;
  }
  return resumed;
}

}  // namespace mjforge::batch
