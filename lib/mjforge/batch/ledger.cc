#include "mjforge/batch/ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <locale>

#include "mjforge/batch/vouched.h"

namespace mjforge::batch {
namespace {

using manifest::Seal;
using manifest::SealedFile;
using output::Durability;

// A line is words, and at its end the checksum of what is before it.
constexpr std::string_view kBegin = "mjforge-journal 1 ";
constexpr std::size_t kChecksumDigits = 16;

std::string ShortChecksumOf(std::string_view text) {
  return bytes::ChecksumOf(text).substr(0, kChecksumDigits);
}

// The words of a line; nothing if its checksum is not theirs.
std::optional<std::string_view> WordsOf(std::string_view line) {
  if (line.size() <= kChecksumDigits) return std::nullopt;
  const std::string_view words = line.substr(0, line.size() - kChecksumDigits - 1);
  if (line.substr(words.size() + 1) != ShortChecksumOf(words)) return std::nullopt;
  return words;
}

Seal SealOfRequest(const SinkOptions& options, const std::filesystem::path& manifest) {
  const Request& request = options.request;
  Seal seal;
  seal.name = request.variant.name;
  if (request.destination.IsArchive()) seal.output = request.destination.path.filename().string();
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

// What is left of a line after the words that were read; names may have spaces. Empty if words were
// missing.
std::string RestOf(std::string_view line, std::istringstream& words) {
  const std::streamoff at = words.tellg();
  return std::string(at < 0 ? std::string_view() : line.substr(static_cast<std::size_t>(at) + 1));
}

}  // namespace

Ledger::Ledger(const SinkOptions& options)
    : options_(options),
      file_(options.request.destination.Manifest(options.request.shard)),
      seal_(SealOfRequest(options, file_)) {}

bool Ledger::Open(diag::Findings& findings) {
  ReadFormer();
  if (!MayTake(findings)) return false;
  manifest_ = output::PartFile::Open(file_, findings);
  if (!manifest_) return false;
  journal_ = output::PartFile::Open(file_.string() + ".journal", findings);
  if (!journal_) {
    if (manifest_->size() == 0) manifest_->Drop();  // made just now
    return false;
  }
  is_begun_ = manifest_->size() > 0 || journal_->size() > 0;
  ReadJournal();
  if (manifest_->size() > 0 && !begun_ && !options_.request.force) {
    output::AddForeign(manifest_->temporary(), findings);
    if (journal_->size() == 0) journal_->Drop();  // made just now
    return false;
  }
  if (!options_.request.resume || !begun_) return true;
  const std::string difference = manifest::DifferenceOfOutput(*begun_, seal_);
  if (!difference.empty()) AddDiffers(manifest_->temporary(), difference, findings);
  return difference.empty();
}

void Ledger::ReadFormer() {
  std::string why_not;
  former_ = ReadSealOf(file_, why_not);
  if (!former_) former_ = ReadSealOf(options_.request.destination.Manifest({}), why_not);
  if (!former_ || former_->spec != seal_.spec) return;
  for (const auto& [name, sha256] : former_->assets) made_assets_.insert(sha256);
}

// Whether the names that this batch will have are free, or those of an earlier run of it.
bool Ledger::MayTake(diag::Findings& findings) const {
  const bool force = options_.request.force;
  constexpr std::string_view kSealStart = R"({"mjforge_seal":)";
  const auto is_seal = [&](std::string_view start) { return kSealStart.starts_with(start); };
  if (!MayReplaceManifest(file_, force, findings) ||
      !output::MayReplace(manifest::SealOf(file_), force, kSealStart.size(), is_seal, findings)) {
    return false;
  }
  if (force || !former_ || former_->output == seal_.output) return true;
  findings.Add(
      diag::Code::kOutputExists, {},
      fmt::format("'{}' is the manifest of '{}'", file_.string(), former_->output),
      "give the archive a name that differs in more than its ending, or overwrite with --force");
  return false;
}

std::string Ledger::DifferenceOfFormer() const {
  return former_ ? manifest::DifferenceOfOutput(*former_, seal_) : std::string();
}

bool Ledger::HasMade(const std::string& archive) const {
  const auto is_it = [&](const SealedFile& file) { return file.file == archive; };
  return made_.contains(archive) || (former_ && std::ranges::any_of(former_->archives, is_it));
}

void Ledger::ReadJournal() {
  std::string why_not;
  std::optional<bytes::LineReader> lines = bytes::LineReader::Open(journal_->temporary(), why_not);
  std::string line;
  std::uint64_t read = 0;
  while (lines && lines->Next(line, why_not) && !lines->torn()) {
    const std::optional<std::string_view> words = WordsOf(line);
    read += line.size() + 1;
    if (!words || !ReadLine(*words)) break;
    Position& last = positions_.empty() ? begin_ : positions_.back();
    if (last.journal_bytes == 0) last.journal_bytes = read;
  }
  std::vector<bytes::Prefix> prefixes;
  prefixes.reserve(positions_.size());
  for (const Position& position : positions_) prefixes.push_back(position.manifest);
  positions_.resize(bytes::CountSound(manifest_->temporary(), prefixes));
}

// False: it is not a line of a journal.
bool Ledger::ReadLine(std::string_view line) {
  if (line.starts_with(kBegin)) {
    std::string why_not;
    begun_ = manifest::ReadSeal(line.substr(kBegin.size()), why_not);
    return begun_.has_value();
  }
  std::istringstream words{std::string(line)};
  words.imbue(std::locale::classic());
  std::string kind;
  words >> kind;
  if (!begun_) return false;
  if (kind == "asset") {
    Asset asset;
    words >> asset.sha256;
    asset.name = RestOf(line, words);
    if (asset.name.empty()) return false;
    if (begun_->spec == seal_.spec) made_assets_.insert(asset.sha256);
    assets_.push_back(std::move(asset));
    return true;
  }
  if (kind == "closed") {
    SealedFile file;
    words >> file.whole.size >> file.whole.checksum;
    file.file = RestOf(line, words);
    if (file.file.empty()) return false;
    made_.insert(file.file);
    closed_.push_back(std::move(file));
    return true;
  }
  if (kind == "made") made_.insert(RestOf(line, words));
  if (kind == "made-asset" && begun_->spec == seal_.spec) made_assets_.insert(RestOf(line, words));
  return kind.starts_with("made") || (kind == "at" && ReadPosition(words));
}

bool Ledger::ReadPosition(std::istringstream& words) {
  Position position;
  words >> position.next >> position.manifest.size >> position.manifest.checksum >>
      position.archive >> position.part.size >> position.part.checksum;
  if (!words) return false;
  position.assets = assets_.size();
  position.closed = closed_.size();
  positions_.push_back(std::move(position));
  return true;
}

bool Ledger::AppendLine(const std::string& line, diag::Findings& findings) {
  return journal_->Append(fmt::format("{} {}\n", line, ShortChecksumOf(line)), findings);
}

bool Ledger::Start(diag::Findings& findings) {
  if (!manifest_->Truncate(0, findings) || !journal_->Truncate(0, findings)) return false;
  positions_.clear();
  assets_.clear();
  closed_.clear();
  std::string seal = manifest::SealText(seal_);
  seal.pop_back();
  if (!AppendLine(std::string(kBegin) + seal, findings) || !AppendMade(findings)) return false;
  // From here on what is under construction is known as ours, whatever happens.
  return options_.request.durability == Durability::kNone ||
         (journal_->Sync(findings) && output::SyncFolder(file_.parent_path(), false, findings));
}

bool Ledger::GoBackTo(const Position& position, diag::Findings& findings) {
  assets_.resize(position.assets);
  closed_.resize(position.closed);
  for (const Asset& asset : assets_) seal_.assets.emplace(asset.name, asset.sha256);
  std::size_t earlier = 0;  // in archives that are closed
  for (const Position& other : positions_) {
    if (other.archive < position.archive) earlier = other.assets;
  }
  assets_.erase(assets_.begin(), assets_.begin() + static_cast<std::ptrdiff_t>(earlier));
  return manifest_->Truncate(position.manifest.size, findings) &&
         journal_->Truncate(position.journal_bytes, findings) && AppendMade(findings);
}

bool Ledger::AppendMade(diag::Findings& findings) {
  const auto append = [&](const char* kind, const std::set<std::string>& all) {
    return std::ranges::all_of(
        all, [&](const std::string& one) { return AppendLine(kind + one, findings); });
  };
  return append("made ", made_) && append("made-asset ", made_assets_);
}

bool Ledger::Append(std::string_view lines, diag::Findings& findings) {
  return manifest_->Append(lines, findings);
}

bool Ledger::HasAsset(const Asset& asset) const {
  return std::ranges::any_of(assets_, [&](const Asset& known) {
    return known.name == asset.name && known.sha256 == asset.sha256;
  });
}

bool Ledger::NoteAsset(const Asset& asset, diag::Findings& findings) {
  if (seal_.assets.emplace(asset.name, asset.sha256).first->second != asset.sha256) {
    output::AddAssetChanged(asset.name, findings);
    return false;
  }
  assets_.push_back(asset);
  return AppendLine(fmt::format("asset {} {}", asset.sha256, asset.name), findings);
}

bool Ledger::Note(const Position& position, diag::Findings& findings) {
  return AppendLine(fmt::format("at {} {} {} {} {} {}", position.next, manifest_->size(),
                                manifest_->checksum(), position.archive, position.part.size,
                                position.part.size == 0 ? "-" : position.part.checksum),
                    findings);
}

bool Ledger::NoteClosed(SealedFile archive, diag::Findings& findings) {
  const std::string line =
      fmt::format("closed {} {} {}", archive.whole.size, archive.whole.checksum, archive.file);
  made_.insert(archive.file);
  closed_.push_back(std::move(archive));
  assets_.clear();
  return AppendLine(line, findings) && (options_.request.durability == Durability::kNone ||
                                        (manifest_->Sync(findings) && journal_->Sync(findings)));
}

bool Ledger::Finish(diag::Findings& findings) {
  const Request& request = options_.request;
  seal_.manifest.whole = {manifest_->size(), manifest_->checksum()};
  seal_.archives = closed_;
  const bool if_changed = request.if_changed || request.resume;
  // The manifest comes last: whoever sees it may believe that all is there.
  if (!output::WriteFile(manifest::SealOf(file_), manifest::SealText(seal_), if_changed, findings,
                         request.durability) ||
      !manifest_->Commit(if_changed, request.durability, findings)) {
    return false;
  }
  journal_->Drop();
  return true;
}

void Ledger::Drop() {
  manifest_->Drop();
  journal_->Drop();
}

}  // namespace mjforge::batch
