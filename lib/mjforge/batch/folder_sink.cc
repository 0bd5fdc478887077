// Sink that writes a folder: workers write the objects, the leading process writes the manifest.

#include <algorithm>
#include <filesystem>
#include <map>

#include "mjforge/batch/journaled_sink.h"
#include "mjforge/batch/output_checker.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

class FolderSink : public JournaledSink {
 public:
  using JournaledSink::JournaledSink;

  output::OverwritePolicy overwrite() const override {
    return {.force = request_.force,
            // If the earlier batch cannot be resumed, its variants are made again. Files that do
            // not change then keep their modification times.
            .if_changed = request_.if_changed || request_.resume,
            .durability = request_.durability,
            .assets = journal_.made_assets(),
            .kept_assets = journal_.assets()};
  }

  bool Take(ChunkResult& result, diag::Findings& findings) override {
    checkpoint_.next = result.chunk.first + result.done;
    const auto note = [&](const HashedAsset& asset) {
      return journal_.HasAsset(asset) || journal_.AddAsset(asset, findings);
    };
    return std::ranges::all_of(result.assets, note) &&
           journal_.AppendRecords(result.lines, findings) &&
           journal_.AddCheckpoint(checkpoint_, findings);
  }

  bool Finish(diag::Findings& findings) override {
    // Workers write objects without fsync, so the objects must reach the disk before the manifest.
    return (request_.durability == output::Durability::kNone ||
            output::SyncFolder(destination_.path, true, findings)) &&
           journal_.Finish(findings);
  }

  // Keeps the journal if a finished batch is hidden of which workers may have replaced files.
  void Drop(bool is_broken) override {
    if (!is_broken || !journal_.has_hidden()) journal_.Drop();
  }

  void RemoveAbandoned() const override {
    output::RemoveAbandoned(destination_.path, options_.range.first, options_.range.count);
  }

 private:
  std::optional<ResumedVariants> Continue(diag::Findings& findings) override {
    // Verifies every file by its hash; missing or changed files are made again.
    OutputChecker objects(destination_.path, true);
    const std::map<std::string, std::string> noted = journal_.is_unfinished() ? journal_.assets()
                                                     : journal_.previous_seal()
                                                         ? journal_.previous_seal()->assets
                                                         : std::map<std::string, std::string>();
    const auto is_there = [&](const manifest::Record& record) {
      diag::Findings ignored;
      if (record.status == Status::kOk && !objects.Check(record, ignored)) return false;
      for (const auto& asset : record.assets) {
        if (noted.contains(asset.first)) kept_assets_.insert(asset);
      }
      return true;
    };
    if (journal_.is_unfinished()) {
      const std::vector<Checkpoint>& checkpoints = journal_.checkpoints();
      const std::uint64_t sound =
          checkpoints.empty() ? 0 : journal_.CountBefore(checkpoints.back());
      const auto resumed = ReadResumable(journal_.part(), options_, is_there, findings, sound);
      return resumed && RollBackTo(*resumed, findings) ? resumed : std::nullopt;
    }
    // If the earlier batch was finished, checks its manifest, and continues at its end.
    const std::optional<manifest::Seal>& seal = journal_.previous_seal();
    if (!seal || !bytes::IsSound(journal_.file(), seal->manifest.content)) return ResumedVariants();
    const std::optional<ResumedVariants> resumed =
        ReadResumable(journal_.file(), options_, is_there, findings);
    if (!resumed || resumed->done() == 0) return resumed;
    // Copies the records of the resumed variants from the earlier manifest to the new one.
    const bool is_copied = journal_.Start(checkpoint_, findings) &&
                           journal_.AppendRecordsOf(journal_.file(), resumed->bytes, findings) &&
                           AddResumedCheckpoint(*resumed, findings);
    return is_copied ? resumed : std::nullopt;
  }

  // Cuts the manifest after the last record whose files are unchanged, which may be in the middle
  // of a chunk.
  bool RollBackTo(const ResumedVariants& resumed, diag::Findings& findings) {
    if (resumed.done() == 0) return true;
    Checkpoint last = journal_.checkpoints().front();
    for (const Checkpoint& checkpoint : journal_.checkpoints()) {
      if (checkpoint.manifest.size <= resumed.bytes) last = checkpoint;
    }
    last.manifest.size = resumed.bytes;
    return journal_.RollBackTo(last, findings) && AddResumedCheckpoint(resumed, findings);
  }

  bool AddResumedCheckpoint(const ResumedVariants& resumed, diag::Findings& findings) {
    checkpoint_.next = options_.range.first + resumed.done();
    const auto note = [&](const auto& asset) {
      return journal_.assets().contains(asset.first) ||
             journal_.AddAsset({.name = asset.first, .source = {}, .sha256 = asset.second},
                               findings);
    };
    return std::ranges::all_of(kept_assets_, note) && journal_.AddCheckpoint(checkpoint_, findings);
  }

  // Names and SHA-256 of the assets in the earlier run's journal or seal to which the resumed
  // records refer.
  std::map<std::string, std::string> kept_assets_;
};

}  // namespace

std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options) {
  return std::make_unique<FolderSink>(options);
}

}  // namespace mjforge::batch
