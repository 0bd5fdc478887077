// Parsing of -o, and formatting of the names of objects, archives, families and manifests.

#include "mjforge/output/destination.h"

#include <fmt/compile.h>

#include <algorithm>
#include <charconv>

namespace mjforge::output {
namespace {

constexpr std::string_view kTar = ".tar";
constexpr std::string_view kTarZstd = ".tar.zst";
constexpr std::string_view kZstd = ".zst";
constexpr std::string_view kNpz = ".npz";
constexpr std::string_view kStructure = "%s";  // placeholder of the structure's key

// Position and width of "%05d" in a pattern.
struct NumberPlaceholder {
  std::size_t at = 0;
  std::size_t length = 0;
  std::uint64_t width = 0;
};

std::optional<NumberPlaceholder> FindNumberPlaceholder(std::string_view pattern) {
  const std::size_t at = pattern.find('%');
  const std::size_t end = pattern.find('d', at);
  if (at == pattern.npos || end == pattern.npos) return std::nullopt;
  const std::string_view digits = pattern.substr(at + 1, end - at - 1);
  const std::optional<std::uint64_t> width = digits.empty() ? 0 : ReadIndex(digits);
  if (!width || *width > 20) return std::nullopt;
  return NumberPlaceholder{at, digits.size() + 2, *width};
}

std::string WithoutEnding(std::string_view name) {
  for (const std::string_view ending : {kTarZstd, kTar, kNpz}) {
    if (name.ends_with(ending)) return std::string(name.substr(0, name.size() - ending.size()));
  }
  return std::string(name);
}

// Returns the name that the archives of a series, or the families of a split batch, have in common:
// "x" for "x_%05d.tar" and "x_%s.npz".
std::string StemOf(const Destination& destination) {
  std::string stem = WithoutEnding(destination.path.filename().string());
  std::optional<NumberPlaceholder> place = FindNumberPlaceholder(stem);
  if (destination.IsSplit()) place = {stem.find(kStructure), kStructure.size(), 0};
  if (place) {
    stem.erase(place->at, place->length);
    stem.erase(stem.find_last_not_of("_-.") + 1);
  }
  return stem;
}

}  // namespace

std::string Shard::Suffix() const {
  return IsWhole() ? std::string() : fmt::format("-{:05}-of-{:05}", index, count);
}

std::filesystem::path Destination::Archive(std::uint64_t number) const {
  std::string name = path.filename().string();
  if (const std::optional<NumberPlaceholder> place = FindNumberPlaceholder(name)) {
    name.replace(place->at, place->length, fmt::format("{:0{}}", number, place->width));
  }
  return path.parent_path() / name;
}

bool Destination::IsSplit() const {
  return kind == Kind::kFamily && path.filename().string().find(kStructure) != std::string::npos;
}

std::filesystem::path Destination::Family(std::string_view key) const {
  std::string name = path.filename().string();
  if (IsSplit()) name.replace(name.find(kStructure), kStructure.size(), key);
  return path.parent_path() / name;
}

std::filesystem::path Destination::Folder() const {
  return kind == Kind::kFolder ? path : path.parent_path();
}

std::filesystem::path Destination::Rows(const Shard& shard) const {
  return Folder() / fmt::format("{}{}.rows", StemOf(*this), shard.Suffix());
}

std::filesystem::path Destination::Manifest(const Shard& shard) const {
  const std::string stem = kind == Kind::kFolder ? std::string() : StemOf(*this);
  return Folder() / fmt::format("{}{}manifest{}.jsonl{}", stem, stem.empty() ? "" : ".",
                                shard.Suffix(), format == ArchiveFormat::kTarZstd ? kZstd : "");
}

bool IsManifestName(std::string_view name) {
  if (name.ends_with(kZstd)) name.remove_suffix(kZstd.size());
  return name.ends_with(".jsonl");
}

std::optional<Destination> ParseDestination(std::string_view text, std::uint64_t per_archive,
                                            std::string& why_not) {
  using Kind = Destination::Kind;
  if (text == "-") return Destination{.kind = Kind::kStandardOutput, .path = {}};
  if (text.ends_with(".xml")) return Destination{.kind = Kind::kFile, .path = text};
  if (text.ends_with(kNpz)) {
    Destination destination{.kind = Kind::kFamily, .path = text};
    if (std::count(text.begin(), text.end(), '%') == (destination.IsSplit() ? 1 : 0))
      return destination;
    return diag::Refuse(
        why_not, "families have one %s in their file's name, for the structure, and no other %");
  }
  const bool zstd = text.ends_with(kTarZstd);
  if (!zstd && !text.ends_with(kTar)) {
    if (text.ends_with(".zst") || text.ends_with(".gz") || text.ends_with(".tgz") ||
        text.ends_with(".zip"))
      return diag::Refuse(why_not, "archives end with .tar or .tar.zst");
    return Destination{.kind = Kind::kFolder, .path = text};
  }
  Destination destination{.kind = Kind::kArchive,
                          .path = text,
                          .format = zstd ? ArchiveFormat::kTarZstd : ArchiveFormat::kTar};
  const std::string name = destination.path.filename().string();
  const std::optional<NumberPlaceholder> number = FindNumberPlaceholder(name);
  const auto percents = std::count(text.begin(), text.end(), '%');
  if (percents > (number ? 1 : 0))
    return diag::Refuse(
        why_not, "a series of archives has one %d or %05d in its file's name, and no other %");
  if (number) {
    destination.kind = Kind::kArchives;
    destination.per_archive = per_archive;
  }
  return destination;
}

bool IsManifest(std::string_view name) {
  constexpr std::string_view kPart = ".part";
  if (name.ends_with(kPart)) name.remove_suffix(kPart.size());
  return IsManifestName(name);
}

std::optional<std::filesystem::path> ManifestOf(const std::string& what) {
  if (bytes::IsFolder(what)) return std::filesystem::path(what) / "manifest.jsonl";
  if (IsManifest(what)) return what;
  std::string why_not;
  const auto destination = ParseDestination(what, 1, why_not);
  if (destination && destination->PacksVariants()) return destination->Manifest({});
  return std::nullopt;
}

std::string VariantStem(std::string_view name, std::uint64_t index) {
  return fmt::format(FMT_COMPILE("{}_{:06}"), name, index);
}

std::optional<std::uint64_t> ReadIndex(std::string_view digits) {
  std::uint64_t index = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, index);
  if (error != std::errc() || stop != end) return std::nullopt;
  return index;
}

std::string PathInFolder(std::string_view name, std::uint64_t index, std::string_view ending) {
  const std::uint64_t folder = index / kFilesPerFolder * kFilesPerFolder;
  if (folder == 0) return VariantStem(name, index).append(ending);
  return fmt::format("{:07}/{}{}", folder, VariantStem(name, index), ending);
}

}  // namespace mjforge::output
