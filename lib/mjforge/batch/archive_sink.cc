#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "mjforge/batch/sink.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

// How far manifest and archives are at the end of a chunk. The journal has a line
// for each; before it, lines "+ NAME" of the assets that came into the archive.
struct Position {
  std::uint64_t next = 0;  // index
  std::uint64_t manifest_bytes = 0;
  std::uint64_t archive = 0;
  std::uint64_t archive_bytes = 0;
  std::set<std::string> assets;  // in the archive
};

std::string Line(const Position& position) {
  return fmt::format("{} {} {} {}\n", position.next, position.manifest_bytes, position.archive,
                     position.archive_bytes);
}

std::vector<Position> ReadJournal(const std::filesystem::path& file) {
  std::vector<Position> positions;
  std::set<std::string> assets;
  std::ifstream journal(file, std::ios::binary);
  std::string line;
  while (std::getline(journal, line) && !journal.eof()) {
    if (line.starts_with("+ ")) {
      assets.insert(line.substr(2));
      continue;
    }
    Position position;
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    if (!(words >> position.next >> position.manifest_bytes >> position.archive >>
          position.archive_bytes)) {
      break;
    }
    if (position.archive_bytes == 0) assets.clear();
    position.assets = assets;
    positions.push_back(std::move(position));
  }
  return positions;
}

class ArchiveSink : public Sink {
 public:
  explicit ArchiveSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        destination_(request_.destination),
        file_(destination_.Manifest(request_.shard)) {}

  std::optional<Kept> Open(diag::Findings& findings) override {
    if (!folders_.Make(destination_.Folder(), findings)) return std::nullopt;
    if (!MayReplaceManifest(file_, request_.force, findings)) return std::nullopt;
    std::error_code ignored;
    ours_ = request_.force || output::PartFile::Exists(file_) ||
            std::filesystem::exists(file_, ignored) ||
            std::filesystem::exists(destination_.Manifest({}), ignored);
    manifest_ = output::PartFile::Open(file_, findings);
    if (!manifest_) return std::nullopt;
    journal_ = output::PartFile::Open(file_.string() + ".journal", findings);
    if (!journal_) return std::nullopt;
    const bool is_begun = manifest_->size() > 0 || journal_->size() > 0;
    const bool is_finished = !is_begun && std::filesystem::exists(file_, ignored);
    return request_.resume && is_finished ? ContinueFinished(findings) : Continue(findings);
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
    std::string journal;
    if (!AppendAssets(result, journal, findings)) return false;
    if (!archive_->Append(result.segment, findings) || !manifest_->Append(result.lines, findings)) {
      return false;
    }
    position_.next = result.chunk.end();
    return Note(journal, findings);
  }

  bool Finish(diag::Findings& findings) override {
    if (is_complete_) {
      Drop();
      return true;
    }
    if (options_.range.count > 0 && !CloseArchive(findings)) return false;
    if (!manifest_->Commit(request_.if_changed || request_.resume, findings)) return false;
    journal_->Drop();
    return true;
  }

  void Drop() override {
    if (archive_) archive_->Drop();
    manifest_->Drop();
    journal_->Drop();
  }

 private:
  std::uint64_t FirstArchive() const {
    const std::uint64_t before = options_.range.first - options_.all.first;
    return destination_.per_archive == 0 ? 0 : before / destination_.per_archive;
  }

  // Of a finished batch nothing is left to do, or everything: where an archive is gone.
  std::optional<Kept> ContinueFinished(diag::Findings& findings) {
    const auto is_there = [&](const manifest::Record& record) {
      std::error_code ignored;
      return record.status != Status::kOk ||
             std::filesystem::exists(destination_.Folder() / record.archive, ignored);
    };
    const std::optional<Kept> kept = ReadKept(file_, options_, is_there, findings);
    if (!kept) {
      Drop();  // made just now
      return std::nullopt;
    }
    is_complete_ = kept->done() == options_.range.count;
    return is_complete_ ? kept : Continue(findings);
  }

  std::optional<Kept> Continue(diag::Findings& findings) {
    position_ = {.next = options_.range.first, .archive = FirstArchive(), .assets = {}};
    Kept kept;
    if (request_.resume) {
      const auto is_good = [](const manifest::Record&) { return true; };
      const std::optional<Kept> whole =
          ReadKept(manifest_->temporary(), options_, is_good, findings);
      if (!whole) return std::nullopt;
      GoBackTo(options_.range.first + whole->done());
      // Again, for the counts at that place.
      kept =
          *ReadKept(manifest_->temporary(), options_, is_good, findings, position_.manifest_bytes);
    }
    if (!manifest_->Truncate(position_.manifest_bytes, findings)) return std::nullopt;
    if (position_.archive_bytes > 0 && !OpenArchive(position_.archive_bytes, findings))
      return std::nullopt;
    // The journal is written anew: what came after the place is not so any more.
    std::string lines;
    for (const std::string& name : position_.assets) lines += fmt::format("+ {}\n", name);
    lines += Line(position_);
    if (!journal_->Truncate(0, findings) || !journal_->Append(lines, findings)) return std::nullopt;
    return kept;
  }

  // The last place in the journal that files and records bear out.
  void GoBackTo(std::uint64_t most) {
    const std::vector<Position> positions = ReadJournal(journal_->temporary());
    for (auto position = positions.rbegin(); position != positions.rend(); ++position) {
      if (position->next <= most && position->manifest_bytes <= manifest_->size() &&
          IsThere(*position)) {
        position_ = *position;
        return;
      }
    }
  }

  bool IsThere(const Position& position) const {
    std::error_code error;
    for (std::uint64_t i = FirstArchive(); i < position.archive; ++i) {
      if (!std::filesystem::exists(destination_.Archive(i), error)) return false;
    }
    if (position.archive_bytes == 0) return true;
    const auto size = std::filesystem::file_size(
        output::PartFile::NameOf(destination_.Archive(position.archive)), error);
    return !error && size >= position.archive_bytes;
  }

  bool OpenArchive(std::uint64_t bytes, diag::Findings& findings) {
    const std::filesystem::path file = destination_.Archive(position_.archive);
    std::error_code ignored;
    if (!ours_ && std::filesystem::exists(file, ignored)) {
      output::AddForeign(file, findings);
      return false;
    }
    archive_ = output::PartFile::Open(file, findings);
    return archive_ && archive_->Truncate(bytes, findings);
  }

  bool CloseArchive(diag::Findings& findings) {
    if (!archive_ && !OpenArchive(0, findings)) return false;
    const bool closed = archive_->Append(output::ArchiveEnd(destination_.format), findings) &&
                        archive_->Commit(request_.if_changed, findings);
    if (closed) archive_.reset();
    return closed;
  }

  bool NextArchive(std::uint64_t number, diag::Findings& findings) {
    if (!CloseArchive(findings)) return false;
    position_.archive = number;
    position_.archive_bytes = 0;
    position_.assets.clear();
    return journal_->Append(Line(position_), findings);
  }

  // Before the first object that refers to them.
  bool AppendAssets(const Result& result, std::string& journal, diag::Findings& findings) {
    for (const auto& [name, source] : result.assets) {
      if (position_.assets.contains(name)) continue;
      const std::optional<std::string> bytes = output::ReadFile(source, bytes::kMaxAsset, findings);
      output::Segment segment(destination_.format);
      if (!bytes || !segment.Add(name, *bytes, findings) ||
          !archive_->Append(segment.Take(), findings)) {
        return false;
      }
      position_.assets.insert(name);
      journal += fmt::format("+ {}\n", name);
    }
    return true;
  }

  bool Note(const std::string& journal, diag::Findings& findings) {
    position_.manifest_bytes = manifest_->size();
    position_.archive_bytes = archive_->size();
    return journal_->Append(journal + Line(position_), findings);
  }

  SinkOptions options_;
  const Request& request_;
  const output::Destination& destination_;
  std::filesystem::path file_;
  output::MadeFolders folders_;
  std::unique_ptr<output::PartFile> manifest_;
  std::unique_ptr<output::PartFile> journal_;
  std::unique_ptr<output::PartFile> archive_;
  Position position_;
  bool ours_ = false;         // an older batch was here, whose archives may be replaced
  bool is_complete_ = false;  // by an earlier run
};

}  // namespace

std::unique_ptr<Sink> MakeArchiveSink(const SinkOptions& options) {
  return std::make_unique<ArchiveSink>(options);
}

}  // namespace mjforge::batch
