// Handler of tasks in a worker: makes variants, and writes or returns files, records and findings.

#include "mjforge/batch/worker.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "mjforge/batch/family_rows.h"

namespace mjforge::batch {
namespace {

using Kind = output::Destination::Kind;

// Returns the name of a variant's files in an archive, without extension.
std::string StemOf(const manifest::Record& record) {
  return record.Folder() + output::VariantStem(record.name, record.index);
}

class ChunkMaker {
 public:
  ChunkMaker(const forge::Recipe& recipe, diag::Sources& sources, const Request& request,
             const output::OverwritePolicy& overwrite, bool lists_variants)
      : request_(request),
        lists_variants_(lists_variants),
        sources_(sources),
        leader_sources_(sources.size()),
        reported_sources_(sources.size()),
        generator_(recipe, sources, OptionsOf(request)),
        folder_(request.destination.Folder(), overwrite),
        segment_(request.destination.format) {}

  ChunkResult operator()(const Task& task, WorkerMailbox& mailbox) {
    ChunkResult result;
    result.chunk = task.chunk;
    record_lines_.clear();
    segment_.Clear();
    made_members_.clear();
    archive_ = request_.destination.Archive(task.chunk.archive).filename().string();
    FindingSummary finding_summary(kMaxFindings);
    for (std::uint64_t i = task.chunk.first; i < task.chunk.end(); ++i) {
      if (mailbox.IsAskedToStop()) break;
      Make(i, task, mailbox);
      if (!HasInputs(result) || !Write(result)) {
        result.files_failed = true;
        break;
      }
      finding_summary.Add(variant_.findings, variant_.record.status == Status::kSkipped);
      Report(result);
    }
    result.lines = request_.destination.format == output::ArchiveFormat::kTarZstd
                       ? frame_.Compress(record_lines_)
                       : record_lines_;
    if (IsFamily()) {
      family_segment_ = family_.Take();
      result.segment = family_segment_;
    } else {
      result.segment = segment_.Bytes();
    }
    result.more_findings = finding_summary.not_shown();
    result.findings.assign(finding_summary.groups().begin(), finding_summary.groups().end());
    for (const FindingSummary::Group& group : result.findings) AddSources(group.finding, result);
    for (const diag::Finding& finding : result.output_findings) AddSources(finding, result);
    // Reports the files that were read since the last task: attached MJCF files.
    while (reported_sources_ < sources_.size())
      result.inputs.push_back(sources_.Name(++reported_sources_));
    return result;
  }

 private:
  void Make(std::uint64_t index, const Task& task, WorkerMailbox& mailbox) {
    const auto quarantined = std::ranges::find(task.quarantined, index, &QuarantinedVariant::index);
    if (quarantined != task.quarantined.end()) {
      generator_.Fail(index, FindingOf(*quarantined), variant_);
    } else {
      mailbox.Begin(index);
      generator_.Make(index, variant_);
      mailbox.End();
    }
  }

  // Returns the finding about a variant whose worker died. The finding has no place in the spec,
  // because the cause of the death is unknown.
  diag::Finding FindingOf(const QuarantinedVariant& quarantined) const {
    diag::Finding finding;
    finding.code = quarantined.too_slow ? diag::Code::kBatchTooSlow : diag::Code::kBatchWorkerDied;
    finding.message = fmt::format("variant {}: its worker {}", quarantined.index, quarantined.how);
    finding.hint = quarantined.too_slow
                       ? "raise --time-limit, or look at the variant with inspect --index"
                   : request_.destination.HasManifest()
                       ? "no other variant is affected; --resume tries this one again"
                       : "look at it with inspect --index";
    return finding;
  }

  bool IsFamily() const { return request_.destination.kind == Kind::kFamily; }

  // Returns false if an input file of the variant could not be read. This is an error of the batch,
  // not a failure of the variant, so that --resume makes the variant again.
  bool HasInputs(ChunkResult& result) const {
    bool has_all = true;
    for (const diag::Finding& finding : variant_.findings) {
      if (!diag::IsInputOutput(finding.code)) continue;
      has_all = false;
      result.output_findings.Add(finding);
    }
    return has_all;
  }

  // Writes the variant and its record to the destination; returns false if that fails.
  bool Write(ChunkResult& result) {
    if (request_.destination.kind == Kind::kNowhere) return true;
    record_line_.clear();
    const manifest::Record& record = variant_.record;
    if (variant_.ok() && !WriteObject(result)) {
      result.output_findings.SetVariant(record.seed, record.index);
      return false;
    }
    if (record_line_.empty()) {
      manifest::AppendRecord(record_lines_, record);
    } else {
      manifest::AppendWithPaths(record_lines_, record_line_, archive_, record.spec_file);
    }
    return true;
  }

  bool WriteObject(ChunkResult& result) {
    const output::Destination& destination = request_.destination;
    diag::Findings& findings = result.output_findings;
    manifest::Record& record = variant_.record;
    if (IsFamily()) {
      record.file.clear();
      const bool is_split = destination.IsSplit();
      record.archive = is_split
                           ? destination.Family(variant_.structure.FamilyKey()).filename().string()
                           : archive_;
      AddAssets(result);
      return family_.Add(variant_, record.archive, findings);
    }
    if (destination.PacksVariants()) {
      record.file =
          StemOf(record).append(record.each ? output::kPlacementEnding : output::kObjectEnding);
    }
    if (destination.kind == Kind::kFolder &&
        !folder_.Write(record.file, variant_.output(), findings, record.assets)) {
      return false;
    }
    AddAssets(result);
    if (destination.kind == Kind::kFolder) return true;
    if (destination.PacksVariants()) return AddMembers(findings);
    result.text = variant_.output().text;
    return true;
  }

  // Returns the path of an asset in the archive, beside the variant's file. For a folder, returns
  // the name that the MJCF contains.
  std::string NameOf(const std::string& asset) const {
    if (!request_.destination.PacksVariants()) return asset;
    return (std::filesystem::path(variant_.record.file).parent_path() / asset).generic_string();
  }

  // Adds the assets of the variant to the result; generated assets only if the leader writes them.
  void AddAssets(ChunkResult& result) const {
    for (const auto& [name, source, made] : variant_.output().assets) {
      if (made && request_.destination.kind != Kind::kFile) continue;
      const auto& hashes = variant_.record.assets;
      const auto hash = std::ranges::find(hashes, name, &output::AssetHashes::value_type::first);
      const HashedAsset asset = {NameOf(name), source.string(), hash->second,
                                 made ? *made : std::string()};
      if (std::ranges::find(result.assets, asset) == result.assets.end())
        result.assets.push_back(asset);
    }
  }

  // Adds the variant's generated assets to the segment, before the variant's object. Each segment
  // gets an asset once, because segments are made independently of each other.
  bool AddMadeFiles(diag::Findings& findings) {
    return std::ranges::all_of(variant_.output().assets, [&](const bytes::Asset& asset) {
      const std::string name = NameOf(asset.name);
      return !asset.made || !made_members_.insert(name).second ||
             segment_.Add(name, *asset.made, findings);
    });
  }

  // Adds the object and its record to the segment.
  bool AddMembers(diag::Findings& findings) {
    manifest::Record& record = variant_.record;
    const std::string stem = StemOf(record);
    // This record contains no paths, so that archives of the same variants have the same bytes.
    std::string spec_file = std::exchange(record.spec_file, {});
    manifest::AppendRecord(record_line_, record);
    record.spec_file = std::move(spec_file);
    return AddMadeFiles(findings) && segment_.Add(record.file, variant_.output().text, findings) &&
           segment_.Add(stem + ".json", record_line_, findings);
  }

  void Report(ChunkResult& result) {
    const manifest::Record& record = variant_.record;
    ++result.done;
    result.statuses.push_back(record.status);
    if (lists_variants_) {
      result.variants.push_back(
          {record.index, record.name, record.status, record.attempt, record.file});
    }
    for (const auto& [name, source, made] : variant_.output().assets) {
      if (!made && variant_.object && reported_assets_.insert(source.string()).second)
        result.inputs.push_back(source.string());
    }
  }

  // Adds to the result the texts that the finding quotes and that the leader does not have.
  void AddSources(const diag::Finding& finding, ChunkResult& result) {
    const auto add = [&](diag::SourceMark mark) {
      const bool is_known = mark.file <= leader_sources_ ||
                            std::ranges::count(result.sources, mark.file, &SourceText::number) > 0;
      if (!is_known)
        result.sources.push_back({mark.file, sources_.Name(mark.file), sources_.Text(mark.file)});
    };
    add(finding.mark);
    for (const diag::Note& note : finding.notes) add(note.mark);
  }

  const Request& request_;
  bool lists_variants_;
  diag::Sources& sources_;
  std::uint32_t leader_sources_;    // number of texts that the leading process has
  std::uint32_t reported_sources_;  // number of texts that the leader has or that were reported
  std::set<std::string> reported_assets_;
  forge::Generator generator_;
  output::ObjectFolder folder_;
  output::Segment segment_;
  std::set<std::string> made_members_;  // generated assets in the segment
  forge::Variant variant_;
  std::string archive_;       // name of the chunk's archive
  std::string record_lines_;  // records of the chunk
  FamilyRows family_;
  std::string family_segment_;
  bytes::FrameCompressor frame_;
  std::string record_line_;  // line of the record in the archive; empty: the archive has no record
};

}  // namespace

std::filesystem::path SnapshotPath(const output::Destination& destination) {
  std::filesystem::path path = destination.Manifest({});
  if (path.extension() == ".zst") path.replace_extension();
  return path.replace_extension(".spec.json");
}

forge::Options OptionsOf(const Request& request) {
  forge::Options options = request.variant;
  if (request.destination.HasManifest()) options.folder = request.destination.Folder();
  options.layout_first = request.first;
  if (options.pad > 0) options.pad = request.count;
  options.family = request.destination.kind == Kind::kFamily;
  if (options.family && options.layout != forge::Layout::kSplit)
    options.layout = forge::Layout::kOne;
  options.snapshot_file = SnapshotPath(request.destination).filename().string();
  return options;
}

TaskHandler MakeTaskHandler(const forge::Recipe& recipe, diag::Sources& sources,
                            const Request& request, const output::OverwritePolicy& overwrite,
                            bool lists_variants) {
  const auto worker =
      std::make_shared<ChunkMaker>(recipe, sources, request, overwrite, lists_variants);
  return [worker](const Task& task, WorkerMailbox& mailbox) { return (*worker)(task, mailbox); };
}

}  // namespace mjforge::batch
