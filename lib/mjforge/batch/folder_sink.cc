// Sink that writes a folder: workers write the objects, the leader writes the manifest.

#include <algorithm>
#include <filesystem>
#include <map>

#include "mjforge/batch/journal.h"
#include "mjforge/batch/sealed_outputs.h"
#include "mjforge/batch/sink.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

class FolderSink : public Sink {
 public:
  explicit FolderSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        folder_(request_.destination.Folder()),
        journal_(options) {
    checkpoint_.next = options_.range.first;
  }

  std::optional<ResumedVariants> Open(diag::Findings& findings) override {
    if (!folders_.Make(folder_, findings)) return std::nullopt;
    if (!journal_.Open(findings)) return std::nullopt;
    RemoveAbandoned();
    std::optional<ResumedVariants> resumed =
        request_.resume ? Continue(findings) : ResumedVariants();
    // Remove the files that journal_.Open() created.
    if (!resumed && !journal_.is_unfinished()) journal_.Drop();
    if (!resumed || (resumed->done() == 0 && !journal_.Start(checkpoint_, findings)))
      return std::nullopt;
    return resumed;
  }

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
            output::SyncFolder(folder_, true, findings)) &&
           journal_.Finish(findings);
  }

  void Drop() override { journal_.Drop(); }

  void RemoveAbandoned() const override {
    output::RemoveAbandoned(folder_, options_.range.first, options_.range.count);
  }

 private:
  std::optional<ResumedVariants> Continue(diag::Findings& findings) {
    // Verify every file by its hash; missing or changed files are made again.
    OutputChecker objects(folder_, true);
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
    // If the earlier batch was finished, check its manifest, and continue at its end.
    std::string why_not;
    const std::optional<manifest::Seal>& seal = journal_.previous_seal();
    if (!seal || !bytes::IsSound(journal_.file(), seal->manifest.content, why_not))
      return ResumedVariants();
    const std::optional<ResumedVariants> resumed =
        ReadResumable(journal_.file(), options_, is_there, findings);
    if (!resumed || resumed->done() == 0) return resumed;
    return journal_.Start(checkpoint_, findings) && Copy(*resumed, findings) ? resumed
                                                                             : std::nullopt;
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

  // Copies the records of the resumed variants from the earlier manifest to the new one.
  bool Copy(const ResumedVariants& resumed, diag::Findings& findings) {
    std::string why_not;
    std::optional<bytes::File> manifest = bytes::File::Open(journal_.file(), why_not);
    std::string buffer(1 << 20, '\0');
    for (std::uint64_t left = resumed.bytes; manifest && left > 0;) {
      const auto count = manifest->Read(
          std::span(buffer).first(std::min<std::uint64_t>(left, buffer.size())), why_not);
      if (count.value_or(0) == 0) return false;
      if (!journal_.AppendRecords(std::string_view(buffer).substr(0, *count), findings))
        return false;
      left -= *count;
    }
    return AddResumedCheckpoint(resumed, findings);
  }

  SinkOptions options_;
  const Request& request_;
  std::filesystem::path folder_;
  output::MadeFolders folders_;  // declared before journal_, to be destroyed after journal_
  Journal journal_;
  Checkpoint checkpoint_;
  // Names and SHA-256 of the assets to which the resumed records refer.
  std::map<std::string, std::string> kept_assets_;
};

}  // namespace

std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options) {
  return std::make_unique<FolderSink>(options);
}

}  // namespace mjforge::batch
