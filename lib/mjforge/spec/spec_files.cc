// Search, reading, parsing and hashing of the files that a spec consists of.

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

namespace {

// Sets the file number in all positions of a tree, except in empty positions.
void SetSource(std::uint32_t source, YamlNode& node) {
  if (node.mark) node.mark.file = source;
  for (YamlNode& item : node.items) SetSource(source, item);
  for (YamlNode::Pair& pair : node.pairs) {
    if (pair.mark) pair.mark.file = source;
    SetSource(source, pair.value);
  }
}

}  // namespace

fs::path Canonical(const fs::path& file) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(file, error);
  return error ? file : canonical;
}

std::optional<fs::path> FindFile(const std::string& reference, const fs::path& folder,
                                 const LoadOptions& options) {
  Snapshot* const snapshot = options.snapshot;
  if (snapshot == nullptr) return Locate(reference, folder, options.search_path);
  const std::pair key(Canonical(folder.empty() ? "." : folder), reference);
  if (const auto known = snapshot->found.find(key); known != snapshot->found.end())
    return known->second;
  auto file = Locate(reference, folder, options.search_path);
  std::error_code error;
  if (file) snapshot->found.emplace(key, fs::absolute(*file, error));
  return file;
}

std::optional<std::uint32_t> ReadSource(const fs::path& file, std::string_view name,
                                        SourceMark mark, Snapshot* snapshot, diag::Sources& sources,
                                        diag::Findings& findings,
                                        Snapshot::Texts Snapshot::*held_texts) {
  const bool is_text = snapshot != nullptr && file == bytes::kStandardInput;
  const std::string shown = is_text ? snapshot->text_name : DisplayName(file);
  if (snapshot != nullptr) {
    const Snapshot::Texts& texts = snapshot->*held_texts;
    const auto held = texts.find(file);
    if (held != texts.end()) return sources.Add(shown, held->second);
  }
  std::string why_not;
  auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
  if (text) {
    if (snapshot != nullptr) (snapshot->*held_texts).emplace(file, *text);
    return sources.Add(shown, *std::move(text));
  }
  findings
      .Add(Code::kYamlCannotRead, mark, fmt::format("cannot read '{}': {}", name, why_not),
           mark ? std::string() : bytes::PipeHint(file))
      .files = {file.string()};
  return std::nullopt;
}

std::optional<fs::path> SpecFiles::Find(const std::string& reference, const fs::path& folder,
                                        SourceMark mark) {
  const auto found = FindFile(reference, folder, options_);
  if (!found) {
    findings_
        .Add(Code::kSpecNotFound, mark, fmt::format("cannot find '{}'", reference),
             NotFoundHint(reference, options_.search_path))
        .files = Candidates(reference, folder, options_.search_path);
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
  const auto source =
      ReadSource(file, DisplayName(file), mark, options_.snapshot, sources_, findings_);
  if (source) {
    files_.push_back(file);
    source_ids_.push_back(*source);
  }
  return source;
}

std::optional<YamlNode> SpecFiles::Parse(const fs::path& file, std::uint32_t source) {
  if (options_.snapshot == nullptr) return ParseYaml(source, sources_, findings_);
  std::shared_ptr<const YamlNode>& known = options_.snapshot->parsed[file];
  if (known == nullptr) {
    const std::size_t before = findings_.size();
    std::optional<YamlNode> root = ParseYaml(source, sources_, findings_);
    if (!root || findings_.size() > before) return root;
    known = std::make_shared<const YamlNode>(*std::move(root));
  }
  YamlNode copy = *known;
  SetSource(source, copy);
  return copy;
}

std::string SpecFiles::Sha256() const {
  std::string texts;
  for (const std::uint32_t source : source_ids_) texts += sources_.Text(source);
  return bytes::Sha256Of(texts);
}

}  // namespace mjforge::spec
