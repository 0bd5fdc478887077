// The files that a spec is made of: finding, reading and hashing.

#include "mjforge/spec/spec_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/spec/locate.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {

namespace fs = std::filesystem;
using diag::Code;
using diag::SourceMark;

fs::path Canonical(const fs::path& file) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file : canonical;
}

std::optional<std::uint32_t> ReadSource(const fs::path& file, std::string_view name,
                                        SourceMark mark, diag::Sources& sources,
                                        diag::Findings& findings) {
  std::string why_not;
  auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
  if (text) return sources.Add(DisplayName(file), *std::move(text));
  findings.Add(Code::kYamlCannotRead, mark, fmt::format("cannot read '{}': {}", name, why_not));
  return std::nullopt;
}

std::optional<fs::path> SpecFiles::Find(const std::string& reference, const fs::path& folder,
                                        SourceMark mark) {
  const auto found = Locate(reference, folder, search_path_);
  if (!found) {
    findings_.Add(Code::kSpecNotFound, mark, fmt::format("cannot find '{}'", reference),
                  NotFoundHint(reference, search_path_));
    return std::nullopt;
  }
  return Canonical(*found);
}

bool SpecFiles::IsOpen(const fs::path& file, SourceMark mark) {
  const auto first = std::ranges::find(open_, file);
  if (first == open_.end()) return false;
  std::string chain;
  for (auto it = first; it != open_.end(); ++it) chain += it->filename().string() + " -> ";
  findings_.Add(Code::kSpecImportCycle, mark,
                fmt::format("file refers to itself: {}{}", chain, file.filename().string()));
  return true;
}

std::optional<std::uint32_t> SpecFiles::Open(const fs::path& file, SourceMark mark) {
  if (const auto known = std::ranges::find(files_, file); known != files_.end())
    return source_ids_[static_cast<std::size_t>(known - files_.begin())];
  const auto source = ReadSource(file, DisplayName(file), mark, sources_, findings_);
  if (source) {
    files_.push_back(file);
    source_ids_.push_back(*source);
  }
  return source;
}

std::string SpecFiles::Sha256() const {
  std::string texts;
  for (const std::uint32_t source : source_ids_) texts += sources_.Text(source);
  return bytes::Sha256Of(texts);
}

}  // namespace mjforge::spec
