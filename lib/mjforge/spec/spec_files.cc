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

std::optional<fs::path> SpecFiles::Find(const std::string& reference, const fs::path& folder,
                                        SourceMark mark) {
  const auto found = Locate(reference, folder, search_path_);
  if (!found) {
    findings_.Add(Code::kSpecNotFound, mark, fmt::format("cannot find '{}'", reference),
                  NotFoundHint(reference, search_path_));
    return std::nullopt;
  }
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(*found, error);
  return error ? *found : canonical;
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
  std::string why_not;
  auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
  if (!text) {
    findings_.Add(Code::kYamlCannotRead, mark,
                  fmt::format("cannot read '{}': {}", DisplayName(file), why_not));
    return std::nullopt;
  }
  const std::uint32_t source = sources_.Add(DisplayName(file), std::move(*text));
  files_.push_back(file);
  source_ids_.push_back(source);
  return source;
}

std::string SpecFiles::Sha256() const {
  std::string texts;
  for (const std::uint32_t source : source_ids_) texts += sources_.Text(source);
  return bytes::Sha256Of(texts);
}

}  // namespace mjforge::spec
