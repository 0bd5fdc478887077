// Resuming: opening the journal of an earlier run, and reading its records that remain valid.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/batch/journaled_sink.h"

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

std::optional<ResumedVariants> JournaledSink::Open(diag::Findings& findings) {
  if (!folders_.Make(destination_.Folder(), findings) || !journal_.Open(findings))
    return std::nullopt;
  RemoveAbandoned();
  const std::optional<ResumedVariants> resumed =
      request_.resume ? Continue(findings) : ResumedVariants();
  // After an error, removes the files that journal_.Open() created, but keeps an unfinished batch.
  if (!resumed && !journal_.is_unfinished()) journal_.Drop();
  if (!resumed || (resumed->done() == 0 && !journal_.Start(checkpoint_, findings)))
    return std::nullopt;
  if (resumed->done() == 0 && !request_.shard.IsWhole()) RemoveMerged(destination_, options_.all);
  return resumed;
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
