#include "mjforge/forge/digest.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

Summary MakeBatch(Generator& generator, const Batch& batch, const Sink& sink) {
  Summary summary;
  Digest digest(kMaxFindings);
  diag::Findings output_findings;
  Variant variant;
  const bool skip = batch.on_invalid == OnInvalid::kSkip;
  for (std::uint64_t i = 0; i < batch.count; ++i) {
    if (batch.stop != nullptr && batch.stop->load(std::memory_order_relaxed)) {
      summary.interrupted = true;
      break;
    }
    generator.Make(batch.first + i, variant);
    if (!variant.ok() && skip) variant.record.status = "skipped";
    ++(variant.ok() ? summary.ok : skip ? summary.skipped : summary.failed);
    digest.Add(variant.findings, !variant.ok() && skip);
    if (sink && !sink(variant, output_findings)) {
      if (variant.ok()) --summary.ok;  // it is nowhere
      summary.output_failed = true;
      break;
    }
  }
  summary.findings = digest.Result();
  summary.more_findings = digest.not_shown();
  summary.findings.Append(std::move(output_findings));
  return summary;
}

Summary MakeFolder(Generator& generator, const Batch& batch, const std::filesystem::path& folder,
                   bool force, const std::function<void(const Variant&)>& watch) {
  diag::Findings open_findings;
  std::optional<output::DirectoryWriter> writer =
      output::DirectoryWriter::Open(folder, force, open_findings);
  if (!writer) {
    Summary summary;
    summary.output_failed = true;
    summary.findings = std::move(open_findings);
    return summary;
  }
  const Sink sink = [&](const Variant& variant, diag::Findings& findings) {
    const bool written =
        !variant.ok() || writer->Write(variant.record.file, variant.document, findings);
    if (!written || !writer->Add(variant.record, findings)) return false;
    if (watch) watch(variant);
    return true;
  };
  Summary summary = MakeBatch(generator, batch, sink);
  if (!summary.output_failed && summary.ok > 0 && !writer->Finish(summary.findings)) {
    summary.output_failed = true;
  }
  return summary;
}

}  // namespace mjforge::forge
