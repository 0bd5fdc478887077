// The journal of a batch: one line for each checkpoint, asset and closed archive, with checksums.

#include "mjforge/batch/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <locale>

#include "mjforge/batch/output_checker.h"
#include "mjforge/batch/worker.h"

namespace mjforge::batch {
namespace {

using manifest::Seal;
using manifest::SealedFile;
using output::Durability;

// A line consists of words and, at its end, the checksum of these words. The first line consists of
// kBegin and the seal of the batch (its options, as JSON).
constexpr std::string_view kBegin = "mjforge-journal 1 ";
constexpr std::size_t kChecksumDigits = 16;

std::string WithChecksum(std::string_view words) {
  return fmt::format("{} {}", words, bytes::ChecksumOf(words).substr(0, kChecksumDigits));
}

// Returns the words of a line of the journal; nullopt if the checksum does not match.
std::optional<std::string_view> VerifiedWords(std::string_view line) {
  if (line.size() <= kChecksumDigits) return std::nullopt;
  const std::string_view words = line.substr(0, line.size() - kChecksumDigits - 1);
  return line == WithChecksum(words) ? std::optional(words) : std::nullopt;
}

// Returns true for JSON files without content, which may be overwritten: an empty object, an empty
// list and null.
bool IsEmptyJson(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
  return text == "{}" || text == "[]" || text == "null";
}

Seal SealOfRequest(const SinkOptions& options, const std::filesystem::path& manifest) {
  const Request& request = options.request;
  Seal seal;
  seal.name = request.variant.name;
  if (request.destination.PacksVariants())
    seal.output = request.destination.path.filename().string();
  seal.per_archive = request.destination.per_archive;
  seal.spec = options.batch.spec;
  seal.first = options.all.first;
  seal.count = options.all.count;
  seal.shard = request.shard.index;
  seal.shards = request.shard.count;
  seal.records = options.range.count;
  seal.manifest.file = manifest.filename().string();
  return seal;
}

// Returns the hidden name of a finished batch's file while another run replaces the batch.
std::filesystem::path FormerNameOf(const std::filesystem::path& file) {
  return file.parent_path() / fmt::format(".{}.former", file.filename().string());
}

// Returns the part of a line after the words that were read: a name, which may contain spaces.
// Returns an empty text if reading the words failed.
std::string RestOfLine(std::string_view line, std::istringstream& words) {
  const std::streamoff at = words.tellg();
  return std::string(at < 0 ? std::string_view() : line.substr(static_cast<std::size_t>(at) + 1));
}

}  // namespace

Journal::Journal(const SinkOptions& options)
    : options_(options),
      file_(options.request.destination.Manifest(options.request.shard)),
      seal_(SealOfRequest(options, file_)) {}

bool Journal::Open(diag::Findings& findings) {
  ReadPreviousSeal();
  if (!MayReplaceOutputs(findings)) return false;
  manifest_file_ = output::PartFile::Open(file_, findings);
  if (!manifest_file_) return false;
  journal_file_ = output::PartFile::Open(file_.string() + ".journal", findings);
  if (!journal_file_) {
    RemoveEmptyFiles();
    return false;
  }
  output::RemoveAbandoned({manifest::SealPathOf(file_)});
  is_unfinished_ = manifest_file_->size() > 0 || journal_file_->size() > 0;
  ReadJournal();
  const auto prefixes = diag::Mapped<bytes::Fingerprint>(checkpoints_, &Checkpoint::manifest);
  checkpoints_.resize(bytes::CountSound(manifest_file_->temporary(), prefixes));
  const bool is_ours =
      journal_seal_ || MayReplaceManifest(part(), options_.request.force, findings);
  if (is_ours && (!options_.request.resume || IsOfThisBatch(findings))) return true;
  RemoveEmptyFiles();
  return false;
}

// Removes the manifest under construction and the journal, which Open() created, if they are empty.
void Journal::RemoveEmptyFiles() {
  for (const auto& file : {&manifest_file_, &journal_file_}) {
    if (*file && (*file)->size() == 0) (*file)->Drop();
  }
}

// Returns the number of variants that earlier runs have made; may stop counting above the number
// that this run needs.
std::uint64_t Journal::VariantsMade() const {
  const std::uint64_t unfinished = checkpoints_.empty() ? 0 : CountBefore(checkpoints_.back());
  if (previous_seal_ && previous_seal_->manifest.file == file_.filename())
    return std::max(unfinished, previous_seal_->records);
  std::string why_not;
  std::optional<bytes::LineReader> lines = bytes::LineReader::Open(file_, why_not);
  std::uint64_t finished = 0;  // counted, because the seal is lost
  for (std::string line; finished <= seal_.records && lines && lines->Next(line, why_not);)
    ++finished;
  return std::max(unfinished, finished);
}

// Returns false, after adding a finding, if the earlier run, finished or not, made another batch,
// or more variants than this one has.
bool Journal::IsOfThisBatch(diag::Findings& findings) const {
  const std::filesystem::path& manifest = is_unfinished_ ? part() : file_;
  const std::optional<Seal>& seal = is_unfinished_ ? journal_seal_ : previous_seal_;
  if (!seal) {  // compares the first record, which has the options that determine the objects
    const auto is_enough = [](const manifest::Record&) { return false; };
    if (!ReadResumable(manifest, options_, is_enough, findings)) return false;
  }
  std::string difference = seal ? manifest::DifferenceOfOutput(*seal, seal_) : std::string();
  if (difference.empty() && VariantsMade() > seal_.records)
    difference = fmt::format("it has more than {} variants", seal_.records);
  if (!difference.empty()) ReportOtherBatch(manifest, difference, findings);
  return difference.empty();
}

void Journal::ReadPreviousSeal() {
  std::string why_not;
  previous_seal_ = manifest::ReadSealBeside(file_, why_not);
  if (!previous_seal_)
    previous_seal_ = manifest::ReadSealBeside(options_.request.destination.Manifest({}), why_not);
  if (!previous_seal_) return;
  for (const SealedFile& archive : previous_seal_->archives) made_archives_.insert(archive.file);
  if (previous_seal_->spec != seal_.spec) return;
  for (const auto& [name, sha256] : previous_seal_->assets) made_assets_.insert(sha256);
}

// Returns true if manifest, seal and the snapshot of the spec do not exist or were made by an
// earlier run. A damaged manifest is recognized by its seal, a damaged seal by the names of its
// first and its last member. JSON without content may be replaced, too.
bool Journal::MayReplaceOutputs(diag::Findings& findings) const {
  const bool force = options_.request.force;
  const bool is_sealed = previous_seal_ && previous_seal_->manifest.file == file_.filename();
  constexpr std::string_view kSealStart = R"({"mjforge_seal":)";
  const auto is_seal = [&](std::string_view text) {
    return kSealStart.starts_with(text.substr(0, text.find('\0')).substr(0, kSealStart.size())) ||
           text.find(R"(,"xxh128":")") != text.npos || IsEmptyJson(std::string(text));
  };
  if (!MayReplaceManifest(file_, force || is_sealed, findings) ||
      !output::MayReplace(manifest::SealPathOf(file_), force, manifest::kMaxSeal, is_seal,
                          findings) ||
      !MayReplaceSnapshot(findings)) {
    return false;
  }
  if (force || !previous_seal_ || previous_seal_->output == seal_.output) return true;
  findings.Add(
      diag::Code::kOutputExists, {},
      fmt::format("'{}' is the manifest of '{}'",
                  (file_.parent_path() / previous_seal_->manifest.file).string(),
                  previous_seal_->output),
      "give the archive a name that differs in more than its ending, or overwrite with --force");
  return false;
}

bool Journal::MayReplaceSnapshot(diag::Findings& findings) const {
  const std::filesystem::path snapshot = SnapshotPath(options_.request.destination);
  if (options_.batch.spec_file != snapshot.filename()) return true;
  return output::MayReplace(snapshot, options_.request.force, spec::kSnapshotHead, spec::IsSnapshot,
                            findings);
}

void Journal::ReadJournal() {
  checkpoints_.clear();
  assets_.clear();
  sources_.clear();
  closed_archives_.clear();
  seal_.assets.clear();
  std::string why_not;
  std::optional<bytes::LineReader> lines =
      bytes::LineReader::Open(journal_file_->temporary(), why_not);
  std::string line;
  std::uint64_t read = 0;
  while (lines && lines->Next(line, why_not) && !lines->is_truncated()) {
    const std::optional<std::string_view> words = VerifiedWords(line);
    read += line.size() + 1;
    if (!words || !ReadLine(*words, read)) break;
  }
}

// Returns false if the line does not belong to a journal. `end` is the size of the journal up to
// the end of this line.
bool Journal::ReadLine(std::string_view line, std::uint64_t end) {
  if (line.starts_with(kBegin)) {
    std::string why_not;
    const std::string seal = fmt::format("{}\n", line.substr(kBegin.size()));
    journal_seal_ = manifest::ReadSeal(seal, why_not);
    return journal_seal_.has_value();
  }
  std::istringstream words{std::string(line)};
  words.imbue(std::locale::classic());
  std::string kind;
  words >> kind;
  if (!journal_seal_) return false;
  if (kind == "asset" || kind == "source") {
    std::string sha256;
    words >> sha256;
    return AddReadAsset(kind == "asset", RestOfLine(line, words), sha256);
  }
  if (kind == "closed") {
    SealedFile file;
    words >> file.content.size >> file.content.checksum;
    file.file = RestOfLine(line, words);
    if (file.file.empty()) return false;
    made_archives_.insert(file.file);
    closed_archives_.push_back(std::move(file));
    assets_.clear();
    return true;
  }
  if (kind == "made") made_archives_.insert(RestOfLine(line, words));
  if (kind == "made-asset" && journal_seal_->spec == seal_.spec)
    made_assets_.insert(RestOfLine(line, words));
  return kind.starts_with("made") || (kind == "at" && ReadCheckpoint(words, end));
}

bool Journal::AddReadAsset(bool is_copy, const std::string& file, const std::string& sha256) {
  if (!is_copy) sources_.emplace(file, sha256);
  if (!is_copy || file.empty()) return !file.empty();
  if (journal_seal_->spec == seal_.spec) made_assets_.insert(sha256);
  seal_.assets.emplace(file, sha256);
  assets_.emplace(file, sha256);
  return true;
}

bool Journal::ReadCheckpoint(std::istringstream& words, std::uint64_t end) {
  Checkpoint checkpoint;
  words >> checkpoint.next >> checkpoint.manifest.size >> checkpoint.manifest.checksum >>
      checkpoint.archive >> checkpoint.part.size >> checkpoint.part.checksum;
  if (!words) return false;
  checkpoint.journal_bytes = end;
  checkpoints_.push_back(std::move(checkpoint));
  return true;
}

bool Journal::AppendLine(const std::string& line, diag::Findings& findings) {
  return journal_file_->Append(WithChecksum(line) + '\n', findings);
}

// Gives the manifest and the seal of a finished batch hidden names if this run replaces the files
// of that batch. Otherwise a manifest would describe other files if this run stopped.
void Journal::HideFormer() {
  if (options_.request.resume) return;  // files get the bytes that the manifest describes
  for (const auto& file : {file_, manifest::SealPathOf(file_)}) {
    std::error_code error;
    std::filesystem::rename(file, FormerNameOf(file), error);
    has_hidden_ |= !error;
  }
}

// Gives the hidden manifest and its seal their names again.
void Journal::ShowFormer() {
  for (const auto& file : {manifest::SealPathOf(file_), file_}) {
    std::error_code ignored;
    std::filesystem::rename(FormerNameOf(file), file, ignored);
  }
}

void Journal::RemoveFormer() {
  for (const auto& file : {manifest::SealPathOf(file_), file_}) {
    std::error_code ignored;
    std::filesystem::remove(FormerNameOf(file), ignored);
  }
}

bool Journal::Start(const Checkpoint& checkpoint, diag::Findings& findings) {
  if (!manifest_file_->Truncate(0, findings) || !journal_file_->Truncate(0, findings)) return false;
  ReadJournal();  // clears the data read before, because the journal is empty now
  std::string seal = manifest::SealText(seal_);
  seal.pop_back();
  if (!AppendLine(std::string(kBegin) + seal, findings) || !AppendEarlierOutputs(findings) ||
      !AddCheckpoint(checkpoint, findings)) {
    return false;
  }
  HideFormer();
  // Once the journal is on the disk, a later run recognizes the files under construction as its
  // own.
  return options_.request.durability == Durability::kNone ||
         (journal_file_->Sync(findings) &&
          output::SyncFolder(file_.parent_path(), false, findings));
}

bool Journal::RollBackTo(const Checkpoint& checkpoint, diag::Findings& findings) {
  if (!manifest_file_->Truncate(checkpoint.manifest.size, findings) ||
      !journal_file_->Truncate(checkpoint.journal_bytes, findings)) {
    return false;
  }
  ReadJournal();
  return AppendEarlierOutputs(findings);
}

bool Journal::AppendEarlierOutputs(diag::Findings& findings) {
  const auto append = [&](const char* kind, const std::set<std::string>& all) {
    return std::ranges::all_of(
        all, [&](const std::string& one) { return AppendLine(kind + one, findings); });
  };
  return append("made ", made_archives_) && append("made-asset ", made_assets_);
}

bool Journal::AddAsset(const HashedAsset& asset, diag::Findings& findings) {
  const auto is_same = [&](std::map<std::string, std::string>& hashes, const std::string& file) {
    const bool same = hashes.emplace(file, asset.sha256).first->second == asset.sha256;
    if (!same) output::AddAssetChanged(file, findings);
    return same;
  };
  if (!is_same(seal_.assets, asset.name)) return false;
  assets_.emplace(asset.name, asset.sha256);
  if (!AppendLine(fmt::format("asset {} {}", asset.sha256, asset.name), findings)) return false;
  if (asset.source.empty()) return true;  // generated
  return is_same(sources_, asset.source) &&
         AppendLine(fmt::format("source {} {}", asset.sha256, asset.source), findings);
}

bool Journal::AddCheckpoint(const Checkpoint& checkpoint, diag::Findings& findings) {
  return AppendLine(
      fmt::format("at {} {} {} {} {} {}", checkpoint.next, manifest_file_->size(),
                  manifest_file_->checksum(), checkpoint.archive, checkpoint.part.size,
                  checkpoint.part.size == 0 ? "-" : checkpoint.part.checksum),
      findings);
}

bool Journal::AddClosedArchive(SealedFile archive, const Checkpoint& next,
                               diag::Findings& findings) {
  const bool is_durable = options_.request.durability == Durability::kBatch;
  // The partial file's name must be on the disk before the journal mentions the archive. If the
  // partial file exists after a power cut, a file with the archive's final name comes from an
  // earlier batch.
  if (is_durable && !output::SyncFolder(file_.parent_path(), false, findings)) return false;
  const std::string line =
      fmt::format("closed {} {} {}", archive.content.size, archive.content.checksum, archive.file);
  made_archives_.insert(archive.file);
  closed_archives_.push_back(std::move(archive));
  assets_.clear();
  return AppendLine(line, findings) && AddCheckpoint(next, findings) &&
         (!is_durable || (manifest_file_->Sync(findings) && journal_file_->Sync(findings)));
}

bool Journal::Finish(diag::Findings& findings) {
  const Request& request = options_.request;
  if (request.destination.format == output::ArchiveFormat::kTarZstd &&
      !manifest_file_->AppendSeekTable(findings)) {
    return false;
  }
  seal_.manifest.content = {manifest_file_->size(), manifest_file_->checksum()};
  seal_.archives = closed_archives_;
  const bool if_changed = request.if_changed || request.resume;
  if (request.if_changed && has_hidden_) ShowFormer();  // an equal manifest remains as it is
  // The manifest gets its final name last, because a manifest with this name means that all other
  // files exist.
  if (!output::WriteFile(manifest::SealPathOf(file_), manifest::SealText(seal_), if_changed,
                         findings, request.durability) ||
      !manifest_file_->Commit(if_changed, request.durability, findings)) {
    return false;
  }
  RemoveFormer();
  journal_file_->Drop();
  return true;
}

void Journal::Drop(bool shows_former) {
  manifest_file_->Drop();
  journal_file_->Drop();
  if (has_hidden_ && shows_former) ShowFormer();
}

}  // namespace mjforge::batch
