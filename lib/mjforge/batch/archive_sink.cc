#include <algorithm>
#include <filesystem>
#include <set>
#include <span>

#include "mjforge/batch/ledger.h"
#include "mjforge/batch/schedule.h"
#include "mjforge/batch/sink.h"
#include "mjforge/batch/vouched.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

class ArchiveSink : public Sink {
 public:
  explicit ArchiveSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        destination_(request_.destination),
        ledger_(options) {}

  std::optional<Kept> Open(diag::Findings& findings) override {
    if (!folders_.Make(destination_.Folder(), findings) || !ledger_.Open(findings))
      return std::nullopt;
    const std::string seal = manifest::SealOf(ledger_.file()).filename().string();
    output::RemoveHalfWritten(destination_.Folder(), false,
                              [&](const std::string& file) { return file == seal; });
    position_.next = options_.range.first;
    position_.archive = FirstArchive();
    const std::optional<Kept> kept = KeptOf(findings);
    if (!kept && !ledger_.is_begun()) ledger_.Drop();  // made just now
    if (!kept || (kept->done() == 0 && !Start(findings))) return std::nullopt;
    return kept;
  }

  bool Take(Result& result, diag::Findings& findings) override {
    if (result.done < result.chunk.count) {
      // Half a segment would make other bytes than a whole one.
      result.statuses.clear();
      result.variants.clear();
      result.findings.clear();
      return true;
    }
    if (result.chunk.archive != position_.archive && !NextArchive(result.chunk.archive, findings))
      return false;
    if (!archive_ && !OpenArchive(0, findings)) return false;
    if (!AppendAssets(result, findings) || !archive_->Append(result.segment, findings) ||
        !ledger_.Append(result.lines, findings)) {
      return false;
    }
    position_.next = result.chunk.end();
    position_.part = {archive_->size(), archive_->checksum()};
    return ledger_.Note(position_, findings);
  }

  bool Finish(diag::Findings& findings) override {
    if (is_complete_) {
      Drop();
      return true;
    }
    const bool is_open = options_.range.count > 0 && !has_closed_last_;
    return (!is_open || CloseArchive(findings)) && ledger_.Finish(findings);
  }

  void Drop() override {
    if (archive_) archive_->Drop();
    ledger_.Drop();
  }

 private:
  std::uint64_t FirstArchive() const {
    const std::uint64_t before = options_.range.first - options_.all.first;
    return destination_.per_archive == 0 ? 0 : before / destination_.per_archive;
  }

  bool Start(diag::Findings& findings) {
    return ledger_.Start(findings) && ledger_.Note(position_, findings);
  }

  std::optional<Kept> KeptOf(diag::Findings& findings) {
    if (!request_.resume) return Kept();
    if (ledger_.is_begun()) return Continue(findings);
    return ledger_.former() ? ContinueFinished(findings) : Kept();
  }

  // Of a finished batch nothing is left to do, or everything: where something was changed.
  std::optional<Kept> ContinueFinished(diag::Findings& findings) {
    const manifest::Seal& seal = *ledger_.former();
    if (const std::string difference = ledger_.DifferenceOfFormer(); !difference.empty()) {
      AddDiffers(ledger_.file(), difference, findings);
      return std::nullopt;
    }
    std::string why_not;
    const bool is_sound =
        bytes::IsSound(ledger_.file(), seal.manifest.whole, why_not) &&
        std::ranges::all_of(seal.archives, [&](const auto& file) { return IsThere(file); });
    if (!is_sound) return Kept();
    const auto is_good = [](const manifest::Record&) { return true; };
    const std::optional<Kept> kept = ReadKept(ledger_.file(), options_, is_good, findings);
    if (!kept) return std::nullopt;
    is_complete_ = kept->done() == options_.range.count;
    return is_complete_ ? kept : Kept();
  }

  // From the last position that manifest, archives and records bear out.
  std::optional<Kept> Continue(diag::Findings& findings) {
    const std::vector<Position>& positions = ledger_.positions();
    if (positions.empty()) return Kept();
    const auto is_good = [](const manifest::Record&) { return true; };
    const std::optional<Kept> whole =
        ReadKept(ledger_.part(), options_, is_good, findings, positions.back().manifest.size);
    if (!whole) return std::nullopt;
    const std::optional<Position> position = LastSound(options_.range.first + whole->done());
    if (!position || position->next == options_.range.first) return Kept();
    // Again, for the counts at that place.
    const std::optional<Kept> kept =
        whole->bytes == position->manifest.size
            ? whole
            : ReadKept(ledger_.part(), options_, is_good, findings, position->manifest.size);
    const manifest::SealedFile last =
        has_closed_last_ ? ledger_.closed().back() : manifest::SealedFile();
    if (!ledger_.GoBackTo(*position, findings)) return std::nullopt;
    position_ = *position;
    if (has_closed_last_) return ledger_.NoteClosed(last, findings) ? kept : std::nullopt;
    const bool is_open = position_.part.size == 0 || OpenArchive(position_.part.size, findings);
    return is_open ? kept : std::nullopt;
  }

  // Also says whether the last archive has its name already.
  std::optional<Position> LastSound(std::uint64_t most) {
    const std::vector<manifest::SealedFile>& closed = ledger_.closed();
    const auto there = static_cast<std::size_t>(std::distance(
        closed.begin(),
        std::ranges::find_if_not(closed, [&](const auto& file) { return IsThere(file); })));
    std::vector<Position> candidates;  // of one archive, the last that can be gone on with
    for (const Position& position : ledger_.positions()) {
      if (position.next > most || !IsEndOfSegment(position)) continue;
      if (position.closed > there || position.closed != position.archive - FirstArchive()) break;
      if (!candidates.empty() && candidates.back().archive != position.archive) candidates.clear();
      candidates.push_back(position);
    }
    if (candidates.empty()) return std::nullopt;
    const Position& last = candidates.back();
    has_closed_last_ = last.next == options_.range.first + options_.range.count &&
                       there == closed.size() && there == last.closed + 1;
    if (has_closed_last_) return last;
    std::vector<bytes::Prefix> prefixes;
    prefixes.reserve(candidates.size());
    for (const Position& position : candidates) prefixes.push_back(position.part);
    // The first is the archive's start, which needs nothing.
    const std::filesystem::path part =
        output::PartFile::NameOf(destination_.Archive(candidates.front().archive));
    const std::size_t sound =
        bytes::CountSound(part, std::span<const bytes::Prefix>(prefixes).subspan(1));
    return candidates[sound];
  }

  // A larger batch goes on where a whole segment of it ends.
  bool IsEndOfSegment(const Position& position) const {
    if (position.next == options_.range.first + options_.range.count) return true;
    const std::uint64_t made = position.next - options_.all.first;
    const std::uint64_t in_archive =
        destination_.per_archive == 0 ? made : made % destination_.per_archive;
    return in_archive % kSegmentVariants == 0;
  }

  bool IsThere(const manifest::SealedFile& archive) const {
    std::string why_not;
    return IsAsSealed(destination_.Folder(), archive, request_.verify, why_not);
  }

  bool OpenArchive(std::uint64_t bytes, diag::Findings& findings) {
    const std::filesystem::path file = destination_.Archive(position_.archive);
    std::error_code ignored;
    if (!request_.force &&
        std::filesystem::exists(std::filesystem::symlink_status(file, ignored)) &&
        !ledger_.HasMade(file.filename().string())) {
      output::AddForeign(file, findings);
      return false;
    }
    archive_ = output::PartFile::Open(file, findings);
    return archive_ && archive_->Truncate(bytes, findings);
  }

  bool CloseArchive(diag::Findings& findings) {
    if (!archive_ && !OpenArchive(0, findings)) return false;
    if (!archive_->Append(output::ArchiveEnd(destination_.format), findings)) return false;
    const std::string name = destination_.Archive(position_.archive).filename().string();
    const bool closed =
        ledger_.NoteClosed({name, {archive_->size(), archive_->checksum()}}, findings) &&
        archive_->Commit(request_.if_changed, request_.durability, findings);
    if (closed) archive_.reset();
    return closed;
  }

  bool NextArchive(std::uint64_t number, diag::Findings& findings) {
    if (!CloseArchive(findings)) return false;
    position_.archive = number;
    position_.part = {};
    return ledger_.Note(position_, findings);
  }

  // Before the first object that refers to them.
  bool AppendAssets(const Result& result, diag::Findings& findings) {
    for (const Asset& asset : result.assets) {
      if (ledger_.HasAsset(asset)) continue;
      if (!ledger_.NoteAsset(asset, findings)) return false;
      const auto bytes = output::ReadAsset(asset.source, asset.sha256, findings);
      output::Segment segment(destination_.format);
      if (!bytes || !segment.Add(asset.name, *bytes, findings) ||
          !archive_->Append(segment.Bytes(), findings)) {
        return false;
      }
    }
    return true;
  }

  SinkOptions options_;
  const Request& request_;
  const output::Destination& destination_;
  output::MadeFolders folders_;  // goes after what is in them
  Ledger ledger_;
  std::unique_ptr<output::PartFile> archive_;
  Position position_;
  bool is_complete_ = false;      // by an earlier run
  bool has_closed_last_ = false;  // by an earlier run, which did not get further
};

}  // namespace

std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options) {
  return std::make_unique<ArchiveSink>(options);
}

}  // namespace mjforge::batch
