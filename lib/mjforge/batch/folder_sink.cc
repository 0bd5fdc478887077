#include <algorithm>
#include <filesystem>

#include "mjforge/batch/ledger.h"
#include "mjforge/batch/sink.h"
#include "mjforge/batch/vouched.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

// Workers write the files; the manifest is written here.
class FolderSink : public Sink {
 public:
  explicit FolderSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        folder_(request_.destination.Folder()),
        ledger_(options) {
    position_.next = options_.range.first;
  }

  std::optional<Kept> Open(diag::Findings& findings) override {
    if (!folders_.Make(folder_, findings)) return std::nullopt;
    if (!ledger_.Open(findings)) return std::nullopt;
    if (request_.resume || ledger_.is_begun()) RemoveHalfWritten();
    std::optional<Kept> kept = request_.resume ? Continue(findings) : Kept();
    if (!kept && !ledger_.is_begun()) ledger_.Drop();  // made just now
    if (!kept || (kept->done() == 0 && !ledger_.Start(position_, findings))) return std::nullopt;
    is_continued_ = kept->done() > 0;
    return kept;
  }

  output::Overwrite overwrite() const override {
    output::Overwrite overwrite = {.force = request_.force,
                                   .if_changed = request_.if_changed,
                                   .durability = request_.durability};
    // What is kept refers to those that are there.
    if (!is_continued_) overwrite.assets = ledger_.made_assets();
    return overwrite;
  }

  bool Take(Result& result, diag::Findings& findings) override {
    position_.next = result.chunk.first + result.done;
    const auto note = [&](const Asset& asset) {
      return ledger_.HasAsset(asset) || ledger_.NoteAsset(asset, findings);
    };
    return std::ranges::all_of(result.assets, note) && ledger_.Append(result.lines, findings) &&
           ledger_.Note(position_, findings);
  }

  bool Finish(diag::Findings& findings) override {
    // The objects first; workers only wrote them.
    return (request_.durability == output::Durability::kNone ||
            output::SyncFolder(folder_, true, findings)) &&
           ledger_.Finish(findings);
  }

  void Drop() override { ledger_.Drop(); }

 private:
  void RemoveHalfWritten() const {
    output::RemoveHalfWritten(folder_, true, [range = options_.range](const std::string& file) {
      const std::optional<std::uint64_t> index = output::IndexOf(file);
      return !index || (*index >= range.first && *index - range.first < range.count);
    });
  }

  std::optional<Kept> Continue(diag::Findings& findings) {
    // What is on disk is trusted by its hash, so that a file that was lost or changed since is made
    // again.
    VouchedObjects objects(folder_, true);
    const auto is_there = [&](const manifest::Record& record) {
      diag::Findings ignored;
      return record.status != Status::kOk || objects.Check(record, ignored);
    };
    if (ledger_.is_begun()) {
      const std::vector<Position>& positions = ledger_.positions();
      const std::uint64_t sound = positions.empty() ? 0 : positions.back().manifest.size;
      const auto kept = ReadKept(ledger_.part(), options_, is_there, findings, sound);
      return kept && GoBackTo(*kept, findings) ? kept : std::nullopt;
    }
    // A finished batch: its manifest is checked, and gone on with where it ends.
    std::string why_not;
    const std::optional<manifest::Seal>& seal = ledger_.former();
    if (!seal || !bytes::IsSound(ledger_.file(), seal->manifest.whole, why_not)) return Kept();
    if (const std::string difference = ledger_.DifferenceOfFormer(); !difference.empty()) {
      AddDiffers(ledger_.file(), difference, findings);
      return std::nullopt;
    }
    const std::optional<Kept> kept = ReadKept(ledger_.file(), options_, is_there, findings);
    if (!kept || kept->done() == 0) return kept;
    return ledger_.Start(position_, findings) && Copy(*kept, findings) ? kept : std::nullopt;
  }

  // A file that is gone may be in the middle of a chunk.
  bool GoBackTo(const Kept& kept, diag::Findings& findings) {
    if (kept.done() == 0) return true;
    Position last = ledger_.positions().front();
    for (const Position& position : ledger_.positions()) {
      if (position.manifest.size <= kept.bytes) last = position;
    }
    last.manifest.size = kept.bytes;
    return ledger_.GoBackTo(last, findings) && Note(kept, findings);
  }

  bool Note(const Kept& kept, diag::Findings& findings) {
    position_.next = options_.range.first + kept.done();
    return ledger_.Note(position_, findings);
  }

  bool Copy(const Kept& kept, diag::Findings& findings) {
    std::string why_not;
    std::optional<bytes::File> manifest = bytes::File::Open(ledger_.file(), why_not);
    std::string buffer(1 << 20, '\0');
    for (std::uint64_t left = kept.bytes; manifest && left > 0;) {
      const auto count = manifest->Read(
          std::span(buffer).first(std::min<std::uint64_t>(left, buffer.size())), why_not);
      if (count.value_or(0) == 0) return false;
      if (!ledger_.Append(std::string_view(buffer).substr(0, *count), findings)) return false;
      left -= *count;
    }
    const auto note = [&](const auto& asset) {
      return ledger_.NoteAsset({.name = asset.first, .source = {}, .sha256 = asset.second},
                               findings);
    };
    return std::ranges::all_of(ledger_.former()->assets, note) && Note(kept, findings);
  }

  SinkOptions options_;
  const Request& request_;
  std::filesystem::path folder_;
  output::MadeFolders folders_;  // goes after what is in them
  Ledger ledger_;
  Position position_;
  bool is_continued_ = false;
};

}  // namespace

std::unique_ptr<Sink> MakeFolderSink(const SinkOptions& options) {
  return std::make_unique<FolderSink>(options);
}

}  // namespace mjforge::batch
